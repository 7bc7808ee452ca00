import type { Finding } from "../wire/messages";

/** What is wrong with the text, for those who do not hover. */
export function FindingList({ findings }: { findings: readonly Finding[] }) {
  return (
    <section className="findings" aria-label="Findings" role="status">
      {findings.length === 0 ? (
        <p className="findings-none">No mistakes found.</p>
      ) : (
        <ul>
          {findings.map((finding) => (
            <li
              key={`${finding.line}:${finding.column}:${finding.code}`}
              className={`word word-${finding.level}`}
            >
              <b>Line {finding.line}</b> {finding.message}
              {finding.hint && " – "}
              <em>{finding.hint}</em>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
