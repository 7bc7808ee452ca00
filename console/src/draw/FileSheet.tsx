import { useEffect, useState } from "react";
import { useHands } from "../app/context";
import { UploadButton, UploadList } from "../operator/UploadList";
import { useFiles } from "../operator/useFiles";
import { useUploads } from "../operator/useUploads";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { t } from "../words/words";

interface FileSheetProps {
  title: string;
  /** Endings of the names that are offered, without the point. */
  endings: readonly string[];
  /** A name that is written; without it, one that is read. */
  proposal?: string;
  /** Warning that a person reads before he chooses. */
  warning?: string | undefined;
  /** Files of this computer that are brought first. */
  given?: readonly File[] | undefined;
  onName: (name: string) => Promise<unknown>;
  onClose: () => void;
}

/** Asks for the name of a file of the part folder; those that are there are offered. */
export function FileSheet(props: FileSheetProps) {
  const { title, endings, proposal, warning, given, onName, onClose } = props;
  const { screen } = useHands();
  const files = useFiles("");
  const uploads = useUploads();
  // biome-ignore lint/correctness/useExhaustiveDependencies: once for each time that files are given
  useEffect(() => uploads.add("", given ?? []), [given]);
  const reads = proposal === undefined;
  const [name, setName] = useState(proposal ?? "");
  const offered = files.filter(({ name, folder }) => !folder && endings.includes(endingOf(name)));
  const use = async (chosen: string) => {
    if (!endings.includes(endingOf(chosen))) {
      screen.tell(t("The name has to end with {0}.", endings.map((e) => `.${e}`).join(", ")));
      return;
    }
    if ((await onName(chosen)) !== false) onClose();
  };
  return (
    <section
      className="file-sheet card"
      role="dialog"
      aria-label={title}
      onKeyDown={(event) => event.key === "Escape" && onClose()}
    >
      <h2>{title}</h2>
      {warning && (
        <p className="file-sheet-warning" role="alert">
          {warning}
        </p>
      )}
      <form
        onSubmit={(event) => {
          event.preventDefault();
          void use(name);
        }}
      >
        <Field label="Name" value={name} onChange={setName} autoFocus />
        <div className="file-sheet-names">
          {offered.length === 0 && (
            <p className="tail-empty">{t("No such file in the part folder.")}</p>
          )}
          {offered.map((file) => (
            <div key={file.name} className="file-sheet-row">
              <button
                type="button"
                className="list-row"
                onClick={() => (reads ? void use(file.name) : setName(file.name))}
              >
                {file.name}
              </button>
              <button
                type="button"
                className="list-row"
                aria-label={t("Versions of {0}", file.name)}
                onClick={() => screen.open({ kind: "versions", name: file.name })}
              >
                {t("Versions…")}
              </button>
            </div>
          ))}
        </div>
        {reads && (
          <UploadList
            uploads={uploads}
            onUse={(name) => void use(name)}
            asks={warning !== undefined}
          />
        )}
        <div className="file-sheet-foot">
          {reads && <UploadButton uploads={uploads} folder="" endings={endings} />}
          <Button onPress={onClose}>Cancel</Button>
          <Button
            type="submit"
            look="primary"
            refused={name.trim() === "" ? t("Enter a name first.") : undefined}
          >
            {reads ? t("Open") : t("Write")}
          </Button>
        </div>
      </form>
    </section>
  );
}

const endingOf = (name: string): string => name.split(".").at(-1)?.toLowerCase() ?? "";
