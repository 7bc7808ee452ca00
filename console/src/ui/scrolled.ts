/**
 * A list takes note of how far it is scrolled when the browser tells, and goes back there when a press gives it the
 * focus. On a busy computer a press may come before the browser has told: the list would move away beneath it, and the
 * press be lost. So the list is told at each press first.
 */
export function tellsListsTheirPlace(of: Document): void {
  const tell = ({ target }: Event) =>
    target instanceof Element &&
    target.closest('[role="listbox"], [role="menu"]')?.dispatchEvent(new Event("scroll"));
  of.addEventListener("pointerdown", tell, true);
}
