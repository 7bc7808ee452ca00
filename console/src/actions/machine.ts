/** Actions of the machine: stop, hold, resume, arm, zero. */

import { leaseOf } from "../link/shown";
import type { Snapshot, State } from "../wire/messages";
import { t } from "../words/words";
import type { Action, World } from "./action";
import { ask, drive } from "./ask";

const machineOf = ({ shown }: World) => shown.snapshot?.machine;

/** Refused unless the machine is in one of these states. */
export function unless(states: readonly State[], words: string) {
  return (world: World): string | undefined => {
    const machine = machineOf(world);
    if (world.shown.status !== "open" || !machine) return t("There is no link to the machine.");
    return states.includes(machine.state) ? undefined : words;
  };
}

export const whenIdle = unless(["idle"], t("The machine is busy."));
const whenStanding = unless(["idle", "held", "stopped", "asking"], t("The machine is busy."));

/** Refused unless the machine stands, armed. */
export function unlessReady(world: World): string | undefined {
  return whenIdle(world) ?? (machineOf(world)?.armed ? undefined : t("Arm the machine first."));
}

/** Never refused: a press of STOP is sent whatever the page believes. */
export const stop: Action = {
  id: "machine.stop",
  title: t("Stop"),
  section: "machine",
  run: (world) => void ask(world, { do: "stop" }),
};

/** The space bar stops; while nothing moves in preview it leads to the large picture and back. */
export const spaceBar: Action = {
  ...stop,
  id: "machine.space",
  title: t("Stop; in preview the large picture, and back"),
  keys: ["Space"],
  run: (world) => {
    stop.run(world);
    const machine = machineOf(world);
    if (machine?.mode === "preview" && machine.state === "idle") {
      world.screen.enlarge(!world.screen.get().large);
    }
  },
};

/** Home as switches tell it: by Kerf's own search, or by that of the controller. */
export const findHome: Action = {
  id: "machine.findHome",
  title: t("Find the machine's home by its switches"),
  section: "machine",
  refused: unlessReady,
  run: (world) => void drive(world, { do: "go", way: { to: "findHome", axes: null } }),
};

export const hold: Action = {
  id: "machine.hold",
  title: t("Hold"),
  section: "machine",
  keys: ["Ctrl+H"],
  refused: unless(["running", "jogging"], t("Nothing moves.")),
  run: (world) => void ask(world, { do: "hold" }),
};

export const resume: Action = {
  id: "machine.resume",
  title: t("Resume"),
  section: "machine",
  refused: unless(["held"], t("Nothing is held.")),
  run: (world) => void drive(world, { do: "resume" }),
};

/** The tool is in for which the controller waits: it goes on. */
export const toolIn: Action = {
  id: "machine.toolIn",
  title: t("Continue: the tool is in"),
  section: "machine",
  refused: (world) =>
    machineOf(world)?.wantsTool ? undefined : t("The controller waits for no tool."),
  run: (world) => void drive(world, { do: "toolIn" }),
};

/** The controller touches the tool off for which it waits; Z zero follows. */
export const touchOff: Action = {
  id: "machine.touchOff",
  title: t("Touch off: the controller measures the tool at the plate below it"),
  section: "machine",
  refused: (world) =>
    machineOf(world)?.touchesOff
      ? unlessReady(world)
      : t("The controller waits for no tool that it touches off."),
  run: (world) => void drive(world, { do: "touchOff" }),
};

/** Runs on the controller have shown a factor of its time: it is forgotten. */
export const forgetPace: Action = {
  id: "machine.forgetPace",
  title: t("Forget what runs have shown of the machine's time"),
  section: "machine",
  refused: (world) =>
    whenStanding(world) ??
    (machineOf(world)?.pace ? undefined : t("Nothing was learned of this machine's time.")),
  run: (world) => void drive(world, { do: "forgetPace" }),
};

export const arm: Action = {
  id: "machine.arm",
  title: t("Arm the machine"),
  section: "machine",
  // A page that was loaded again while a job stands arms the machine to go on.
  refused: (world) =>
    whenStanding(world) ?? (machineOf(world)?.armed ? t("It is armed.") : undefined),
  run: (world) => void drive(world, { do: "arm" }),
};

export const disarm: Action = {
  id: "machine.disarm",
  title: t("Disarm the machine"),
  section: "machine",
  refused: (world) => (machineOf(world)?.armed ? undefined : t("It is not armed.")),
  run: (world) => void ask(world, { do: "disarm" }),
};

export const acknowledge: Action = {
  id: "machine.acknowledge",
  title: t("Acknowledge the alarm"),
  section: "machine",
  refused: unless(["alarm"], t("There is no alarm.")),
  run: (world) => void ask(world, { do: "acknowledge" }),
};

export const takeControl: Action = {
  id: "machine.take",
  title: t("Take control"),
  section: "machine",
  refused: ({ shown }) =>
    shown.snapshot?.lease?.client === shown.who?.client ? t("You drive already.") : undefined,
  run: (world) => void ask(world, { do: "takeLease", force: true }),
};

/** Lets another page, or a program beside Kerf, drive. */
export const giveControl: Action = {
  id: "machine.give",
  title: t("Give up control"),
  section: "machine",
  refused: ({ shown }) => (leaseOf(shown) === undefined ? t("You do not drive.") : undefined),
  run: (world) => {
    const lease = leaseOf(world.shown);
    if (lease !== undefined) void ask(world, { do: "giveLease", lease });
  },
};

/** A line of OpenSBP as an action. */
export function command(id: string, title: string, line: string): Action {
  return {
    id,
    title,
    section: "machine",
    refused: unlessReady,
    run: (world) => void drive(world, { do: "command", line }),
  };
}

/** A line that moves nothing: it needs no armed machine. */
export const modeOf = (id: string, title: string, line: string): Action => ({
  ...command(id, title, line),
  refused: whenIdle,
});

export const preview = modeOf("machine.preview", t("Preview mode: files are only drawn"), "SP");
export const moveMode = modeOf("machine.move", t("Move mode: files are cut"), "SM");
export const clearPreview = modeOf("machine.clear", t("Clear the preview"), "SP");
const zero = (id: string, title: string, line: string): Action => ({
  ...command(id, title, line),
  warns: () => t("The place where the tool is becomes the new zero."),
});

export const zeroXY = zero("machine.zero.xy", t("Zero X and Y"), "Z2");
/** The zero of the work, which is not the home of the machine. */
export const home = command("machine.home", t("Go to work zero"), "JH");

/** Zeroing of each axis, X to B. */
export const zeroAxis: readonly Action[] = ["X", "Y", "Z", "A", "B"].map((letter) =>
  zero(`machine.zero.${letter.toLowerCase()}`, t("Zero {0}", letter), `Z${letter}`),
);

/** Switches an output the other way (SO). The first two are those that start something that turns. */
const switchOutput = (n: number): Action => ({
  id: `machine.output.${n}`,
  title: t("Switch output {0}", n),
  section: "machine",
  refused: unlessReady,
  warns: () => t("Output {0} may start what turns or moves. Is everybody clear of it?", n),
  run: (world) => {
    const on = world.shown.snapshot?.io.outputs.find(({ number }) => number === n)?.on;
    void drive(world, { do: "command", line: `SO,${n},${on ? 0 : 1}` });
  },
});

/** Switches of the outputs 1 to 12. */
export const outputs: readonly Action[] = Array.from({ length: 12 }, (_, n) => switchOutput(n + 1));

/** Reason that a machine tells while it is disarmed, held or in alarm. */
export const whyOf = (snapshot: Snapshot | null): string => snapshot?.machine.why ?? "";

export const machineActions: readonly Action[] = [
  stop,
  spaceBar,
  hold,
  findHome,
  resume,
  touchOff,
  toolIn,
  forgetPace,
  arm,
  disarm,
  acknowledge,
  takeControl,
  giveControl,
  preview,
  moveMode,
  home,
  zeroXY,
  ...zeroAxis,
  ...outputs,
];
