/** What keys go into. */

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

/** Whether letters go into it, and spaces. */
export const takesText = (target: EventTarget | null): target is HTMLElement =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLInputElement && !notWritten.includes(target.type)));

/** Whether keys other than the space bar mean something in it. */
export const takesKeys = (target: EventTarget | null): boolean =>
  takesText(target) || target instanceof HTMLInputElement || target instanceof HTMLSelectElement;

/** Whether it is switched by a press, and a press is all that it knows. */
export const isSwitch = (target: EventTarget | null): target is HTMLInputElement =>
  target instanceof HTMLInputElement && ["checkbox", "radio"].includes(target.type);

/** Leaves a field: the focus goes to what it stands in. */
export function leave(field: HTMLElement): void {
  field.closest<HTMLElement>("[role=dialog], [role=alertdialog]")?.focus();
  if (document.activeElement === field) field.blur();
}
