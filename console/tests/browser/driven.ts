/** A shop that drives a pretended controller, for tests. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { Controller } from "./controller";
import { openWorkshop, type Workshop } from "./workshop";

export interface Driven {
  controller: Controller;
  workshop: Workshop;
  page: Page;
  /** Closes the shop, then unplugs the controller: what a hook returns. */
  close: () => Promise<void>;
}

/** Opens one with part files, by their names; words say what the controller is like. */
export async function driveController(
  files: Record<string, string> = {},
  ...words: string[]
): Promise<Driven> {
  const controller = new Controller(...words);
  const workshop = await openWorkshop({ controller: `grbl:${await controller.port()}` });
  for (const [name, text] of Object.entries(files)) {
    writeFileSync(join(workshop.parts, name), text);
  }
  const close = async () => {
    await workshop.close();
    controller.unplug();
  };
  return { controller, workshop, page: await workshop.page(), close };
}
