/** The German text of a code of findings. */

export interface FindingText {
  /** The mistake in a few words. */
  readonly title: string;
  /** A way to mend it. */
  readonly mend: string;
}

export const told = (title: string, mend: string): FindingText => ({ title, mend });
