import { useEffect, useRef } from "react";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { drawingWords } from "../app/drawingWords";
import { useBusy } from "../app/useBusy";
import { useWords } from "../app/useWords";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import { colourWords } from "../words/operations";
import { t } from "../words/words";
import { chooseStart } from "./actions";
import { type Plan, type Share, type Standing, shareOf } from "./plan";
import { ValueField } from "./ValueField";

/** Paths that a list shows round the one at hand: a job can have a million. */
const most = 400;

const words: Record<Share, string> = {
  skipped: t("left out"),
  waiting: "",
  running: t("cutting"),
  done: t("done"),
};

interface PathPanelProps {
  plan: Plan;
  standing: Standing;
}

/** The paths in cutting order, and the one with which the job begins. */
export function PathPanel({ plan, standing }: PathPanelProps) {
  const count = plan.paths.length;
  return (
    <Panel
      title="Paths"
      className="job-paths"
      aside={<span className="listing-count">{count}</span>}
    >
      <StartChoice count={count} start={standing.start} />
      <PathList plan={plan} standing={standing} />
      <Comments />
      <Findings />
    </Panel>
  );
}

function StartChoice({ count, start }: { count: number; start: number }) {
  const hands = useHands();
  const busy = useBusy();
  const first = start <= 1 ? t("It begins with the first path.") : undefined;
  const last = start >= count ? t("It begins with the last path.") : undefined;
  const begin = (number: number) =>
    chooseStart(worldOf(hands), Math.min(Math.max(Math.round(number), 1), count));
  return (
    <div className="start-choice">
      <ValueField
        label={t("Begins with path")}
        value={start}
        isDisabled={busy !== undefined}
        onSet={begin}
      />
      <Button
        size="small"
        aria-label="The path before"
        refused={busy ?? first}
        onPress={() => void begin(start - 1)}
      >
        −
      </Button>
      <Button
        size="small"
        aria-label="The next path"
        refused={busy ?? last}
        onPress={() => void begin(start + 1)}
      >
        +
      </Button>
      <Button size="small" refused={busy ?? first} onPress={() => void begin(1)}>
        First
      </Button>
    </div>
  );
}

function PathList({ plan, standing }: PathPanelProps) {
  const hands = useHands();
  const here = standing.runs ? standing.at : standing.start;
  const from = Math.max(0, Math.min(here - most / 2, plan.paths.length - most));
  const shown = plan.paths.slice(from, from + most);
  const row = useRef<HTMLLIElement>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: follows the path at hand
  useEffect(() => {
    row.current?.scrollIntoView({ block: "nearest" });
  }, [here]);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a list that scrolls must be reached by key
    <ol className="path-list" aria-label={t("Paths in cutting order")} tabIndex={0}>
      {shown.map(({ shape, traversal, tool }) => {
        const share = shareOf(shape.number, standing);
        return (
          <li
            key={shape.number}
            ref={shape.number === here ? row : null}
            className={`path-row path-${share}`}
            aria-current={share === "running" ? "step" : undefined}
          >
            <button
              type="button"
              onClick={() => void chooseStart(worldOf(hands), shape.number)}
              title={t("Begin with this path")}
            >
              <b>{shape.number}</b>
              <i style={{ background: `var(--draw-group-${shape.group})` }} aria-hidden="true" />
              <span>
                {colourWords(shape.group)}
                {traversal ? t(", way round") : t(", tool {0}", tool)}
                {shape.pause && <em>{t("pause")}</em>}
              </span>
              <span className="path-share">{words[share]}</span>
            </button>
          </li>
        );
      })}
    </ol>
  );
}

/** The comments of the job for whoever cuts it: material, customer, warnings. */
function Comments() {
  const comments = useSnapshot("opened")?.header;
  return comments ? (
    <section className="path-comments" aria-label={t("Comments of the file")}>
      {comments}
    </section>
  ) : null;
}

/** Lists the findings of the job, before it is started. */
function Findings() {
  const words = useWords();
  const findings = useSnapshot("opened")?.findings ?? [];
  if (findings.length === 0) return null;
  return (
    <ul className="path-findings" aria-label={t("Findings")}>
      {findings.map(({ message }) => (
        <li key={message}>{words(drawingWords(message))}</li>
      ))}
    </ul>
  );
}
