import type { ReactNode } from "react";
import type { Spot } from "../app/screen";
import { useWords } from "../app/useWords";
import { FindingPlace } from "../operator/FindingPlace";
import type { Finding } from "../wire/messages";
import { findingWords } from "../words/findings";
import { t } from "../words/words";
import type { Check } from "./check";

interface FindingListProps {
  check: Check;
  /** The file in the editor; a new one has no name. */
  file: string;
  onShow: (place: Spot) => void;
}

/** Lists the findings in the text, for those who do not hover; and says if all of it was looked at. */
export function FindingList({ check, file, onShow }: FindingListProps) {
  const words = useWords();
  return (
    <section className="findings" aria-label={t("Findings")} role="status">
      {check.is === "checking" && <p className="findings-none">{t("Checking…")}</p>}
      {check.is === "unchecked" && (
        <p className="word word-warning">{t("Not checked: {0}.", words(check.why))}</p>
      )}
      {check.is === "lines" && <Share {...check} />}
      {"findings" in check && (
        <Found findings={check.findings} file={file} onShow={onShow}>
          {check.is === "checked" && t("No mistakes found.")}
        </Found>
      )}
    </section>
  );
}

/** The share of a long text that was looked at, and the checks that a long text does without. */
function Share({ share }: { share: number }) {
  const text =
    share < 1
      ? t("Not checked yet: {0} % of the text.", Math.ceil((1 - share) * 100))
      : t("Each line was checked by itself. Not checked: jumps, variables and units.");
  return <p className="findings-none">{text}</p>;
}

interface FoundProps {
  findings: readonly Finding[];
  file: string;
  onShow: (place: Spot) => void;
  /** The words where there are none. */
  children: ReactNode;
}

/** Findings that are listed: nobody reads more. */
const most = 300;

function Found({ findings, file, onShow, children }: FoundProps) {
  const words = useWords();
  if (findings.length === 0) return children ? <p className="findings-none">{children}</p> : null;
  return (
    <ul>
      {findings
        .slice(0, most)
        .map(findingWords)
        .map((finding) => (
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
      {findings.length > most && <li>{t("… and {0} more", findings.length - most)}</li>}
    </ul>
  );
}

function placeIn({ file: own, line }: Finding, file: string): Spot | undefined {
  return line > 0 ? { file: own || file, line } : undefined;
}
