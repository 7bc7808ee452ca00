/** Tools that change what is in sight. */

import { t } from "../../words/words";
import { boxOf } from "../geometry/vec";
import { regionOf, type Tool } from "./tool";

const zoomWindow: Tool = {
  id: "zoom-window",
  title: t("Zoom window"),
  doc: t("Shows a region as large as it fits."),
  menu: "view",
  asks: [{ ask: "region", prompt: t("Region") }],
  clauses: () => "",
  look: ([region]) => boxOf(regionOf(region).from, regionOf(region).to),
};

export const viewTools: readonly Tool[] = [zoomWindow];
