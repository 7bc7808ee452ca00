/** Tells which elements of the page take typed keys. */

/** Fields that a space is no letter of. */
const notWritten = [
  "button",
  "checkbox",
  "color",
  "file",
  "image",
  "radio",
  "range",
  "reset",
  "submit",
];

/** Tells whether letters and spaces go into an element. */
export const takesText = (target: EventTarget | null): target is HTMLElement =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLInputElement && !notWritten.includes(target.type)));

/** Tells whether keys other than the space bar mean something in an element. */
export const takesKeys = (target: EventTarget | null): boolean =>
  takesText(target) || target instanceof HTMLInputElement || target instanceof HTMLSelectElement;

/** Tells whether an element is a switch: it is pressed, and takes nothing else. */
export const isSwitch = (target: EventTarget | null): target is HTMLInputElement =>
  target instanceof HTMLInputElement && ["checkbox", "radio"].includes(target.type);

/** Leaves a field: the focus goes to what it stands in. */
export function leave(field: HTMLElement): void {
  field.closest<HTMLElement>("[role=dialog], [role=alertdialog]")?.focus();
  if (document.activeElement === field) field.blur();
}
