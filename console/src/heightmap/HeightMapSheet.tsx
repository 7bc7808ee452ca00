import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { useWords } from "../app/useWords";
import { findCommand, useCommands } from "../command/table";
import { getJson } from "../link/http";
import { EntryFields } from "../probe/EntryFields";
import { Touched } from "../probe/Touched";
import { type Maker, useMaker } from "../probe/useMaker";
import "../probe/probe.css";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { difference } from "../units/quantity";
import type { CommandEntry, PreviewInfo } from "../wire/messages";
import { findingWords } from "../words/findings";
import { t } from "../words/words";
import { HeightPicture } from "./HeightPicture";
import { gridOver, probedPlaces } from "./heights";
import { InForce } from "./InForce";
import "./height-map.css";

/** The part file that TM makes. */
const program = "probe_heights.sbp";

/** A surface that is not flat: probed on a grid, shown, and followed by what is cut. */
export function HeightMapSheet({ onClose }: { onClose: () => void }) {
  const entry = findCommand(useCommands(true), "TM");
  return entry ? <HeightMapForm entry={entry} onClose={onClose} /> : null;
}

/** The place of an entry by its name. */
const placeOf = ({ parameters }: CommandEntry, name: string): number =>
  parameters.findIndex((parameter) => parameter.name === name);

function HeightMapForm({ entry, onClose }: { entry: CommandEntry; onClose: () => void }) {
  const maker = useMaker(entry, program);
  const map = useSnapshot("heightMap");
  const { entries, refused, isMade, make } = maker;
  const places = entry.parameters.flatMap(({ name }, n) => (name === "Part file" ? [] : [n]));
  const input = Number(entries[placeOf(entry, "Probe, input")] ?? 1);
  const inForce = map ? t("Take the map off first: places are probed without one.") : undefined;
  return (
    <Sheet
      title={t("Height map")}
      shape="side"
      onClose={onClose}
      foot={
        <>
          <Touched isMade={isMade && !map} input={input} />
          <Button look="primary" refused={inForce ?? refused} onPress={make}>
            Make the program
          </Button>
        </>
      }
    >
      <InForce />
      {!map && <Probed />}
      <h3>{t("Probe a surface")}</h3>
      <p className="probe-words">
        {t("Set Z zero on the surface before. Every place is touched twice, fast and slow.")}
      </p>
      <OverFile entry={entry} maker={maker} />
      <EntryFields entry={entry} maker={maker} places={places} />
    </Sheet>
  );
}

/** Lays the grid over the cuts of the open file. */
function OverFile({ entry, maker }: { entry: CommandEntry; maker: Maker }) {
  const hands = useHands();
  const unit = useLengthUnit();
  const opened = useSnapshot("opened");
  const preview = opened?.name === program ? undefined : opened?.preview;
  const key = preview?.state === "ready" ? preview.key : undefined;
  const motion = useShown((shown) => shown.snapshot?.motion);
  const lay = async () => {
    if (key === undefined || !motion) return;
    const { machine, working } = motion.at;
    const zero = [difference(machine[0], working[0]), difference(machine[1], working[1])] as const;
    const info = await getJson<PreviewInfo>(`/api/preview/${encodeURIComponent(key)}`);
    const over = gridOver(info, zero, unit);
    if (!over) return worldOf(hands).screen.tell(t("It cuts nothing."));
    const names = entry.parameters.map(({ name }) => name);
    maker.setEntries(maker.entries.map((text, n) => over[names[n] ?? ""] ?? text));
  };
  return (
    <Button
      refused={key === undefined ? t("No file is open that cuts.") : undefined}
      onPress={() => void lay().catch((error: Error) => hands.screen.tell(error.message))}
    >
      Bounds of the open file
    </Button>
  );
}

/** The places that the last run has probed so far. */
function Probed() {
  const words = useWords();
  const job = useSnapshot("job");
  const printed = useSnapshot("printed") ?? [];
  if (job?.file !== program) return null;
  const { places, of } = probedPlaces(printed);
  const failed = job.ended !== null && job.ended !== "ok" && job.ended !== "ended";
  return (
    <section aria-label={t("Places that are probed")}>
      <p role="status">{t("{0} of {1} places are probed.", places.length, of)}</p>
      {places.length > 0 && <HeightPicture places={places} />}
      {failed && (
        <p className="probe-wrong">
          {job.error ? words(findingWords(job.error).message) : t("The run has ended.")}
        </p>
      )}
    </section>
  );
}
