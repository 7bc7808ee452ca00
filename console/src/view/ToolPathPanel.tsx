import { useEffect, useMemo, useRef, useState } from "react";
import { useHands, useScreen, useShown, useSnapshot } from "../app/context";
import { useDisplay } from "../app/display";
import { useLengthUnit } from "../app/useLengthUnit";
import { useWords } from "../app/useWords";
import { errorsOf, mistakesText, movesMade, placeOf } from "../operator/fileStatus";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import { type LengthUnit, seconds } from "../units/quantity";
import type { Motion, Opened, PreviewInfo } from "../wire/messages";
import { phrase, t } from "../words/words";
import type { Bounds, Vec3 } from "./camera";
import type { Marks } from "./overlay";
import { PathFacts } from "./PathFacts";
import { PathTools } from "./PathTools";
import { PlayBar } from "./PlayBar";
import { placeAt, timeOfMoves } from "./place";
import { stretches } from "./progress";
import type { Recorded } from "./recorded";
import { ToolPathView } from "./ToolPathView";
import type { ToolPath } from "./toolPath";
import { around, typedBounds } from "./typed";
import type { TypedMarks } from "./typedInk";
import { useCamera } from "./useCamera";
import { usePlayback } from "./usePlayback";
import { useRecorded } from "./useRecorded";
import { useSize } from "./useSize";
import { useToolPath } from "./useToolPath";
import { type TypedView, useTyped } from "./useTyped";
import "./tool-path-panel.css";

/** The open file's tool path with the machine in it. */
export function ToolPathPanel() {
  const opened = useSnapshot("opened");
  const motion = useSnapshot("motion");
  const units = useSnapshot("units");
  const unit = useLengthUnit();
  const moves = useShown(movesMade);
  const { path, rotary } = useLookedAt(opened);
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box);
  const { camera, aspect, chosen: aimed, look, shows, zoomBy, handlers } = useCamera(size);
  const typed = useTyped();
  const bounds = useMemo(() => boundsOfAll(path, typed), [path, typed]);
  const origin = originOf(path);
  const recorded = useRecorded({ origin, data: bounds, shows, zoomOut: () => zoomBy(0.5) });
  const fitted = useRef<PreviewInfo>(undefined);
  const reach = JSON.stringify(bounds);
  // biome-ignore lint/correctness/useExhaustiveDependencies: fits a new path, and again in other room
  useEffect(() => {
    if (!bounds || size.width === 0) return;
    if (fitted.current !== path?.info || !aimed.current) look(aspect, bounds, size);
    fitted.current = path?.info;
  }, [path?.info, reach, size.width, size.height]);
  const planned = path?.info.seconds ?? seconds(0);
  const [playback, setPlayback] = usePlayback(planned);
  const [chosen, setStock] = useState<boolean | null>(null);
  const display = useDisplay();
  const simulates = display?.simulate ?? false;
  const jogs = display?.jogs ?? true;
  const stock = chosen ?? simulates;
  const large = useScreen("large");
  const film = playback.at !== null && path ? placeAt(path.coarse, playback.at)?.at : undefined;
  const marks = useMemo(() => {
    return marksOf(path, { ...typed, jogs }, motion, moves, unit, film, recorded);
  }, [path, typed, motion, moves, unit, film, jogs, recorded]);
  const now = playback.at ?? (path ? timeOfMoves(path.coarse, moves) : 0);
  return (
    <Panel
      title="Tool path"
      className={`path-panel ${large ? "path-large" : ""}`}
      aside={
        <PathTools
          aspect={aspect}
          look={(next) => bounds && look(next, bounds, size)}
          stock={{ on: stock, set: setStock }}
          rotary={rotary}
        />
      }
    >
      {/* biome-ignore lint/a11y/noStaticElementInteractions: the buttons above do the same by key */}
      <div
        ref={box}
        className="path-box"
        {...handlers}
        onWheel={(event) => {
          const at = event.currentTarget.getBoundingClientRect();
          zoomBy(Math.exp(-event.deltaY / 500), event.clientX - at.left, event.clientY - at.top);
        }}
        onContextMenu={(event) => event.preventDefault()}
      >
        <ToolPathView
          path={path}
          camera={camera}
          size={size}
          now={now}
          marks={rotary?.on ? onWork(marks) : marks}
          stock={stock}
        />
        <PathWords path={path} typed={typed} opened={opened} recorded={recorded} />
      </div>
      {path && units && !opened?.broken && <PathFacts info={path.info} units={units} />}
      {isMapped(opened) && <p className="path-mapped">{t("Z follows the height map.")}</p>}
      <SampledWith count={opened?.samples.length ?? 0} />
      {path && !opened?.broken && (
        <PlayBar playback={playback} planned={planned} onChange={setPlayback} />
      )}
    </Panel>
  );
}

/** The note of the server that what was drawn follows a height map. */
const isMapped = (opened: Opened | null | undefined): boolean =>
  opened?.findings.some(({ code }) => code === "M011") ?? false;

/** Says that a program that asks was previewed with sample answers, and leads to them. */
function SampledWith({ count }: { count: number }) {
  const { screen } = useHands();
  if (count === 0) return null;
  return (
    <p className="path-samples">
      {phrase(
        "It asks {0}: this is drawn with sample answers.{1}",
        count === 1 ? t("a question") : t("{0} questions", count),
        <Button size="small" onPress={() => screen.open({ kind: "samples" })}>
          Sample answers…
        </Button>,
      )}
    </p>
  );
}

/** The path that is looked at: as the tool goes, or where it lies on the work that an axis turns. */
function useLookedAt(opened: Opened | null | undefined) {
  const [on, set] = useState(false);
  const preview = opened?.preview;
  const shows = preview?.state === "ready" && !opened?.cleared;
  const path = useToolPath(shows ? `${preview.key}${on ? "~rotary" : ""}` : undefined);
  return { path, rotary: path?.info.rotary ? { on, set } : undefined };
}

/** The picture is of the work as it is turned, not of where the tool stands. */
const onWork = (marks: Marks): Marks => ({
  ...marks,
  tool: undefined,
  made: undefined,
  recorded: undefined,
});

interface PathWordsProps {
  path: ToolPath | null;
  typed: TypedView;
  opened: Opened | null | undefined;
  recorded: Recorded | undefined;
}

/** Words in place of a missing picture. */
function PathWords(props: PathWordsProps) {
  const { screen } = useHands();
  const inUnits = useWords();
  const words = wordsFor(props);
  if (words === undefined) return null;
  const { opened } = props;
  const place = opened?.broken ? placeOf(errorsOf(opened)[0], opened) : undefined;
  return (
    <p className="path-words">
      {place ? (
        <button
          type="button"
          className="finding-place text-link"
          // The box behind it takes a press for the beginning of a turn.
          onPointerDown={(event) => event.stopPropagation()}
          onClick={() => screen.showLine(place)}
        >
          {inUnits(words)}
        </button>
      ) : (
        inUnits(words)
      )}
    </p>
  );
}

function wordsFor({ path, typed, opened, recorded }: PathWordsProps): string | undefined {
  if ((typed.path.segments > 0 || recorded) && (!opened || opened.cleared)) return undefined;
  if (!opened) return t("Choose a file to see its tool path.");
  if (opened.preview.state === "failed") return opened.preview.why;
  if (opened.broken) return t("No tool path: {0}.", mistakesText(opened));
  if (opened.cleared) return t("The preview is cleared. Start draws the file again.");
  return path === null ? t("Reading…") : undefined;
}

/** The bounds of the open file and of the typed moves together. */
function boundsOfAll(path: ToolPath | null, { path: typed }: TypedView): Bounds | undefined {
  const origin = originOf(path);
  const bounds = typedBounds(typed);
  const drawn = bounds && { min: minus(bounds.min, origin), max: minus(bounds.max, origin) };
  return around(path ? boundsOf(path.info) : undefined, drawn);
}

/** The origin of the picture's places; the machine's zero without a tool path. */
const originOf = (path: ToolPath | null): Vec3 => path?.info.origin ?? [0, 0, 0];

const minus = (place: readonly number[], origin: Vec3): Vec3 => [
  (place[0] ?? 0) - origin[0],
  (place[1] ?? 0) - origin[1],
  (place[2] ?? 0) - origin[2],
];

/** Bounds of the picture: the cuts, else the table. Relative to the preview's origin. */
function boundsOf(info: PreviewInfo): Bounds {
  const relative = (place: readonly number[]): Vec3 => minus(place, info.origin);
  if (info.bounds) return { min: relative(info.bounds[0]), max: relative(info.bounds[1]) };
  const [x, y] = info.table;
  const z = info.zero[2];
  return {
    min: relative([x, y, z]),
    max: relative([x + info.tableSize[0], y + info.tableSize[1], z]),
  };
}

function marksOf(
  path: ToolPath | null,
  typed: Omit<TypedMarks, "origin">,
  motion: Motion | undefined,
  moves: number,
  unit: LengthUnit,
  film: Vec3 | undefined,
  recorded: Recorded | undefined,
): Marks {
  const origin = originOf(path);
  const drawn = { ...typed, origin };
  const tool = motion && minus(motion.at.machine, origin);
  if (!path) {
    const shows = typed.path.segments > 0 || typed.live.length > 0 || recorded;
    const zero = motion && minus(motion.at.machine, spotOf(motion.at.working));
    const marks = shows ? { tool, zero } : { tool: undefined, zero: undefined };
    return { ...marks, made: undefined, typed: drawn, recorded, cutter: 0, unit };
  }
  const { zero, cutter } = path.info;
  // A film shows the plan: how far the machine has come belongs to the run.
  const made = film || !tool ? undefined : madeOf(path, moves, tool);
  return {
    tool: film ?? tool,
    zero: minus(zero, origin),
    made,
    typed: drawn,
    recorded,
    cutter,
    unit,
  };
}

const spotOf = (place: readonly number[]): Vec3 => minus(place, [0, 0, 0]);

const madeOf = (path: ToolPath, made: number, tool: Vec3) =>
  stretches(path.coarse, timeOfMoves(path.coarse, made), tool).find((stretch) => stretch.made);
