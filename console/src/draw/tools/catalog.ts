/** Every tool of the drawing. */

import { arrangeTools } from "./arrange";
import { editTools } from "./edit";
import { insertTools } from "./insert";
import { orderTools } from "./order";
import type { Menu, Tool } from "./tool";
import { viewTools } from "./view";

export const tools: readonly Tool[] = [
  ...insertTools,
  ...editTools,
  ...arrangeTools,
  ...orderTools,
  ...viewTools,
];

export const menus: readonly { readonly menu: Menu; readonly title: string }[] = [
  { menu: "insert", title: "Draw" },
  { menu: "edit", title: "Edit" },
  { menu: "arrange", title: "Arrange" },
  { menu: "path", title: "Cutting" },
  { menu: "sequence", title: "Order" },
  { menu: "view", title: "Look" },
];

export const toolsOf = (menu: Menu): readonly Tool[] => tools.filter((tool) => tool.menu === menu);
