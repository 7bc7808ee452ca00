/** The check that the probe works before it is trusted: touched by hand, its input closes and opens again. */

export interface Contact {
  /** Its input is closed. */
  readonly isClosed: boolean;
  /** It was closed since the check began. */
  readonly wasClosed: boolean;
}

export const unchecked: Contact = { isClosed: false, wasClosed: false };

export const seen = ({ wasClosed }: Contact, isClosed: boolean): Contact => ({
  isClosed,
  wasClosed: wasClosed || isClosed,
});

/** The probe was seen to close, and is open: it may be moved. */
export const isChecked = ({ isClosed, wasClosed }: Contact): boolean => wasClosed && !isClosed;
