/** A second device: it is let in by a code, looks and stops as an observer, and is put out again. */

import { networkInterfaces } from "node:os";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, comesToRest, moment, openWorkshop, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({
    lan: true,
    parts: ["01-first-cut/first-cut.sbp"],
    open: "first-cut.sbp",
  });
});
afterAll(() => workshop?.close());

/** An address of this computer by which others reach it; nothing where it has no network. */
const outside = Object.values(networkInterfaces())
  .flat()
  .find((one) => one?.family === "IPv4" && !one.internal)?.address;

it.skipIf(!outside)(
  "an observer is paired with keys only, looks and stops; revoked, it is out",
  async () => {
    const owner = await workshop.page();
    expect(owner.url(), "the address bar has forgotten the token").toBe(`${workshop.address}/`);
    await arm(owner);
    await owner.getByRole("link", { name: "Settings" }).click();
    await owner.getByRole("button", { name: /^New observer/ }).click();
    const code = (await owner.getByLabel("Code for the new device").textContent()) ?? "";
    expect(code).toMatch(/^\d{8}$/);

    const context = await workshop.browser.newContext({ viewport: { width: 1024, height: 768 } });
    const tablet = await context.newPage();
    const { port } = new URL(workshop.address);
    await tablet.goto(`http://${outside}:${port}`);
    await tablet.getByRole("dialog", { name: "Pair this device" }).waitFor();
    await tablet.getByLabel("Code").fill("00000000");
    await tablet.getByLabel("Name of this device").fill("Tablet");
    await tablet.keyboard.press("Enter");
    await tablet.getByText("this is not the code that the machine shows").waitFor();
    await owner
      .getByText(/^Pairing: .+ tried a wrong code, 1 wrong so far/)
      .first()
      .waitFor();
    await tablet.getByLabel("Code").fill(code);
    await tablet.keyboard.press("Enter");
    await tablet.getByText("wait 1 s, then try again").waitFor();
    await moment(1100);
    await tablet.keyboard.press("Enter");
    await tablet.locator(".location-number").first().waitFor();

    // The code is used up, and the device is in the list.
    await owner.getByText("Tablet · observer").waitFor();
    await owner.getByLabel("Code for the new device").waitFor({ state: "detached" });
    await owner.getByRole("link", { name: "Operate" }).click();
    await owner.getByRole("button", { name: "Start" }).click();
    await owner.getByRole("button", { name: "OK" }).click();
    await until(async () => (await stateOf(workshop)).machine.state === "running", "it runs");

    await tablet.getByText(/^Driven by/).waitFor();
    await tablet.getByRole("button", { name: "Take control" }).click();
    await tablet.getByText(/needs the role operator/i).waitFor();
    await tablet.getByRole("button", { name: "STOP", exact: true }).click();
    await until(async () => (await stateOf(workshop)).machine.state !== "running", "it is stopped");
    await until(async () => (await stateOf(workshop)).motion.speedMmS === 0, "nothing moves");

    await comesToRest(workshop);
    await owner.getByRole("link", { name: "Settings" }).click();
    await owner.getByRole("button", { name: "Revoke" }).click();
    await owner.getByText("No other device is paired.").waitFor();
    await tablet.reload();
    await tablet.getByRole("dialog", { name: "Pair this device" }).waitFor();
  },
);
