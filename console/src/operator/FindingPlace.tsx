import type { Spot } from "../app/screen";
import { t } from "../words/words";

interface FindingPlaceProps {
  /** Nothing where the finding has no line. */
  place: Spot | undefined;
  /** The file that is shown beside it, whose name need not be told. */
  file?: string | undefined;
  onShow: (place: Spot) => void;
}

/** The line of a finding; a click leads there in the editor. */
export function FindingPlace({ place, file, onShow }: FindingPlaceProps) {
  if (!place) return <b>{t("All of it")}</b>;
  const words = file === place.file ? "" : t(" of {0}", place.file);
  return (
    <button type="button" className="finding-place text-link" onClick={() => onShow(place)}>
      {t("Line {0}{1}", place.line, words)}
    </button>
  );
}
