/** Every tool of the drawing. */

import { t } from "../../words/words";
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
  { menu: "insert", title: t("Draw") },
  { menu: "edit", title: t("Change") },
  { menu: "arrange", title: t("Arrange") },
  { menu: "path", title: t("Cutting") },
  { menu: "sequence", title: t("Order") },
  { menu: "view", title: t("Look") },
];

export const toolsOf = (menu: Menu): readonly Tool[] => tools.filter((tool) => tool.menu === menu);
