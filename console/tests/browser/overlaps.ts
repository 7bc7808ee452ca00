/** Finds what lies over each other on a page, what is cut off and what no finger reaches. */

import type { Page } from "playwright-core";

/** Every fault of the layout as a line; none where everything can be read and pressed. */
export const overlaps = (page: Page): Promise<string[]> => page.evaluate(faultsOf);

/** Runs in the page, so it is one function that needs nothing from outside. */
function faultsOf(): string[] {
  /** A difference of so few pixels is nobody's fault, px. */
  const slack = 2;
  const wordsOf = (e: Element) =>
    `${e.tagName.toLowerCase()}.${e.className} “${(e.getAttribute("aria-label") ?? e.textContent ?? "").trim().slice(0, 30)}”`;
  const isSeen = (e: Element) => {
    const style = getComputedStyle(e);
    return style.visibility === "visible" && style.clipPath === "none" && Number(style.opacity) > 0;
  };
  /** Part of a box that is left within everything that cuts it off. */
  const clipped = (e: Element, box: DOMRect) => {
    let [left, top, right, bottom] = [box.left, box.top, box.right, box.bottom];
    for (let at: Element | null = e; at && at !== document.body; at = at.parentElement) {
      const style = getComputedStyle(at);
      if (style.position === "fixed") break;
      if (style.overflow === "visible") continue;
      const edge = at.getBoundingClientRect();
      [left, top] = [Math.max(left, edge.left), Math.max(top, edge.top)];
      [right, bottom] = [Math.min(right, edge.right), Math.min(bottom, edge.bottom)];
    }
    return { left, top, right, bottom };
  };
  const around = [
    ...document.querySelectorAll("header.strip, main.screen, [role=dialog], .hand-console"),
  ];
  const within = (selector: string) =>
    around.flatMap((part) => [...part.querySelectorAll(selector)]);

  /** A switch is pressed by its label. */
  const targetOf = (e: Element) => (e.matches("input") ? (e.closest("label") ?? e) : e);
  const reachFault = (e: Element): string[] => {
    e.scrollIntoView({ block: "nearest", inline: "nearest" });
    const box = e.getBoundingClientRect();
    if (box.left < -slack || box.right > innerWidth + slack) return [`outside: ${wordsOf(e)}`];
    const hit = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
    const isHit = hit && (e.contains(hit) || hit.contains(e) || hit.closest(".notices"));
    return isHit ? [] : [`under ${hit ? wordsOf(hit) : "nothing"}: ${wordsOf(e)}`];
  };
  const unreachable = within("button, a[href], input:not([type=range]), select, textarea")
    .filter((e) => isSeen(e) && !e.closest("[inert], .hidden-text, .cm-editor, .feed"))
    .map(targetOf)
    .filter((e) => e.getBoundingClientRect().width > 1)
    .flatMap(reachFault);
  for (const part of document.querySelectorAll(".screen, .screen *")) part.scrollTop = 0;

  const cut = within("button")
    .filter((e) => isSeen(e) && e.scrollWidth > e.clientWidth + slack)
    .map((e) => `cut off: ${wordsOf(e)}`);

  // Nobody can scroll these, so what goes beyond their edge is lost.
  const lost = within(".panel")
    .filter((e) => isSeen(e) && e.scrollWidth > e.clientWidth + slack)
    .map((e) => `lost beyond the edge: ${wordsOf(e)}`);

  const isText = (node: Node): node is Text =>
    node.nodeType === Node.TEXT_NODE && node.textContent?.trim() !== "";
  const texts = within("*")
    .filter(
      (e) =>
        isSeen(e) &&
        !e.closest("[inert], .hidden-text, svg, .cm-editor, select, .listing, .space-types"),
    )
    .flatMap((e) =>
      [...e.childNodes].filter(isText).flatMap((node) => {
        const range = document.createRange();
        range.selectNodeContents(node);
        const layer = e.closest("[role=dialog], .hand-console, header.strip, .screen");
        return [...range.getClientRects()].map((box) => ({ e, layer, box: clipped(e, box) }));
      }),
    )
    .filter(({ box }) => box.right - box.left > slack && box.bottom - box.top > slack);
  const printed = texts.flatMap((one, n) =>
    texts
      .slice(n + 1)
      .filter(({ layer }) => layer === one.layer)
      .filter(({ e }) => !e.contains(one.e) && !one.e.contains(e))
      .filter(({ box }) => {
        const across = Math.min(box.right, one.box.right) - Math.max(box.left, one.box.left);
        const down = Math.min(box.bottom, one.box.bottom) - Math.max(box.top, one.box.top);
        return across > slack && down > 2 * slack;
      })
      .map(({ e }) => `overprints: ${wordsOf(one.e)} and ${wordsOf(e)}`),
  );

  const wide = document.querySelector(".screen");
  const scrolls =
    wide && wide.scrollWidth > wide.clientWidth + slack ? ["the screen scrolls across"] : [];
  return [...new Set([...unreachable, ...cut, ...lost, ...printed, ...scrolls])];
}
