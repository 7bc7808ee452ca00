import { useEffect, useState } from "react";
import { useWords } from "../app/useWords";
import { getText } from "../link/http";
import { t } from "../words/words";

/** Characters that are shown: nobody reads more of it in a sheet. */
const most = 40_000;

interface FileTextProps {
  /** The address of its content. */
  address: string;
  label: string;
}

/** The text of a file, to be looked at. */
export function FileText({ address, label }: FileTextProps) {
  const words = useWords();
  const [text, setText] = useState(t("Reading…"));
  const [refusal, setRefusal] = useState<string>();
  useEffect(() => {
    const abort = new AbortController();
    getText(address, abort.signal).then(
      (all) => setText(shortened(all)),
      (error: Error) => abort.signal.aborted || setRefusal(error.message),
    );
    return () => abort.abort();
  }, [address]);
  return (
    <section className="file-text" aria-label={label}>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what is longer than its box is scrolled by keys */}
      <pre tabIndex={0}>{refusal === undefined ? text : words(refusal)}</pre>
    </section>
  );
}

const shortened = (text: string): string =>
  text.length > most
    ? `${text.slice(0, most)}\n${t("… and {0} characters more", text.length - most)}`
    : text;
