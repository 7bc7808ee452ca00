import { Button } from "../ui/Button";
import { phrase, t } from "../words/words";

interface RecordedProps {
  /** Nothing while places are not recorded. */
  places: readonly string[] | null;
  onChange: (places: readonly string[] | null) => void;
  onKeep: (axes: number) => void;
}

/** Places that are kept as moves. */
export function Recorded({ places, onChange, onKeep }: RecordedProps) {
  if (!places) {
    return (
      <Button size="small" onPress={() => onChange([])}>
        {t("Record places")} <kbd>#</kbd>
      </Button>
    );
  }
  return (
    <section className="recorded" aria-label={t("Recorded places")}>
      <div className="recorded-tools">
        {[2, 3].map((axes) => (
          <Button key={axes} size="small" onPress={() => onKeep(axes)}>
            {phrase("Keep J{0} {1}", axes, <kbd>{axes}</kbd>)}
          </Button>
        ))}
        <Button size="small" onPress={() => void navigator.clipboard?.writeText(places.join("\n"))}>
          Copy
        </Button>
        <Button size="small" look="quiet" onPress={() => onChange(null)}>
          End
        </Button>
      </div>
      <pre className="recorded-list">{places.join("\n") || t("Nothing is recorded yet.")}</pre>
    </section>
  );
}
