import { Button } from "../ui/Button";

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
        Record places <kbd>#</kbd>
      </Button>
    );
  }
  return (
    <section className="recorded" aria-label="Recorded places">
      <div className="recorded-tools">
        {[2, 3].map((axes) => (
          <Button key={axes} size="small" onPress={() => onKeep(axes)}>
            Keep J{axes} <kbd>{axes}</kbd>
          </Button>
        ))}
        <Button size="small" onPress={() => void navigator.clipboard?.writeText(places.join("\n"))}>
          Copy
        </Button>
        <Button size="small" look="quiet" onPress={() => onChange(null)}>
          End
        </Button>
      </div>
      <pre className="recorded-list">{places.join("\n") || "Nothing is recorded yet."}</pre>
    </section>
  );
}
