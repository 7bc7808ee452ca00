/** Texts of the server that no person reads at a page, for the test that asks for German ones. */

/** Files of crates whose texts go to programs, to the shell or into files; each with its reason. */
export const notForPages: Readonly<Record<string, RegExp>> = {
  // Documentation of routes, answers to scripts, the page of roles, vector pictures, names of locks.
  server:
    /^(?:http\/(?:routes|assets|rest|language|preview|registry)|who_may_what|thumbnails|preview\/thumbnail|testing|locks|lib|handconsole\/happening)\.rs/,
  // Answers from a script, and the questions of `kerf machine wire`, for which the page has forms.
  control: /^(?:asking|controller\/sent_tests|controller\/queued\/wizard\/question)\.rs/,
  "driver-grbl": /^fake/,
  "driver-linuxcnc": /^fake/,
  // Words of the protocol.
  "driver-klipper": /^(?:fake|orders|dictionary|setup)/,
  formats: /(?:write|binary)\.rs$/,
  // SQL.
  journal: /^(?:rows|database)\.rs/,
  // Names and explanations of operations have tables of their own.
  drawing: /^op\/(?:entries|write|form|clause)\.rs/,
  // Settings and terminals have tables of their own; only these files make sentences.
  machine: /^(?!contradictions|hand\/|file\/read|table\/bounds|homing)/,
};

/** Texts among others that are read: files' own lines, keys, words of protocols. */
export const texts: readonly string[] = [
  "in {}",
  "at {}",
  "keypad hold paused pause msgbox",
  "Kerf {}, machine {}\nState: {}, {}\nFile: {}\nLast job: {}\n",
  "\nProblem log:\n",
  "\nSent to the controller and answered, without reports and ok:\n",
  "# time (UTC), > sent or < came, the line, # what it means\n",
  "{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age=31536000",
  "camera=(), microphone=(), geolocation=()",
  "default-src 'none'; frame-ancestors 'none'",
  "messages are texts",
  "the number of a jog is above the one before, by {} at most: count the jogs of a page",
  "only stop, hold, disarm and jogStop are heard here: ask the console for the rest",
  "no text with this hash was typed into",
  '"tmc5160 PC4"',
  '"tmc2209 gpio9 gpio8 2"',
  "jog {},{},{},{},{},{} {}",
  "kerf map off",
  "kerf machine home",
  "'Settings of Kerf.",
  "the script of answers has to fit what is asked",
  "AUX IO",
  "hi {}",
  "piece {}",
  "g {} {}",
  "feed {}",
  "rapid {}",
  "turn {}",
  "zero {}",
  "switch {} {}",
  "Converted from {}",
  "Converted from {}\n{}",
  " in SD file at line ",
  " at line ",
  "Cannot open",
  "free space",
  "Converted from {}\nSettings: machine in {}",
  "Settings: depth {}, safe height {}{}{}",
  "display: none",
  "visibility: hidden",
  "{}tool={} overlap={}",
  " zigzag={} finish={}",
  "{} mm in {} s",
  "Roboto Bold",
  "{},Total Time,{}",
  "transform: {}",
];
