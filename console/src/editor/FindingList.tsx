import type { Spot } from "../app/screen";
import { useWords } from "../app/useWords";
import { FindingPlace } from "../operator/FindingPlace";
import type { Finding } from "../wire/messages";
import { t } from "../words/words";
import type { Check } from "./check";

interface FindingListProps {
  check: Check;
  /** The file in the editor; a new one has no name. */
  file: string;
  onShow: (place: Spot) => void;
}

/** What is wrong with the text, for those who do not hover; and whether all of it was looked at. */
export function FindingList({ check, file, onShow }: FindingListProps) {
  return (
    <section className="findings" aria-label={t("Findings")} role="status">
      {check.is === "checking" && <p className="findings-none">{t("Checking…")}</p>}
      {check.is === "unchecked" && (
        <p className="word word-warning">{t("Not checked: {0}.", check.why)}</p>
      )}
      {check.is === "checked" && <Found findings={check.findings} file={file} onShow={onShow} />}
    </section>
  );
}

interface FoundProps {
  findings: readonly Finding[];
  file: string;
  onShow: (place: Spot) => void;
}

function Found({ findings, file, onShow }: FoundProps) {
  const words = useWords();
  if (findings.length === 0) return <p className="findings-none">{t("No mistakes found.")}</p>;
  return (
    <ul>
      {findings.map((finding) => (
        <li
          key={`${finding.file}:${finding.line}:${finding.column}:${finding.code}`}
          className={`word word-${finding.level}`}
        >
          <FindingPlace place={placeIn(finding, file)} file={file} onShow={onShow} />{" "}
          {words(finding.message)}
          {finding.hint && " – "}
          <em>{words(finding.hint)}</em>
        </li>
      ))}
    </ul>
  );
}

function placeIn({ file: own, line }: Finding, file: string): Spot | undefined {
  return line > 0 ? { file: own || file, line } : undefined;
}
