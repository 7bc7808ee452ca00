/** The German text of a setting of the machine. */

export interface SettingText {
  readonly name: string;
  readonly doc: string;
}

export const said = (name: string, doc: string): SettingText => ({ name, doc });
