import { sizeText } from "../operator/fileWords";
import { Button } from "../ui/Button";
import type { CardAct, CardFile } from "../wire/messages";
import { t } from "../words/words";
import type { Question } from "./CardQuestion";
import { timeOf } from "./card";

interface CardFilesProps {
  files: readonly CardFile[];
  refused: string | undefined;
  /** Asks a person before something is done. */
  ask: (question: Question) => void;
  asks: (task: CardAct) => void;
}

/** The files with their sizes and times, and what can be done with each. */
export function CardFiles({ files, refused, ask, asks }: CardFilesProps) {
  if (files.length === 0) return null;
  return (
    <ul className="controller-card-files">
      {files.map((file) => (
        <li key={file.name}>
          <p>
            <b>{file.name}</b>
            <span>{sizeText(file.bytes)}</span>
            <span title={t("Estimated time")}>{timeOf(file)}</span>
          </p>
          <div className="controller-card-acts">
            <Button
              size="small"
              look="go"
              refused={refused}
              aria-label={t("Run {0}…", file.name)}
              onPress={() => ask({ to: "run", name: file.name })}
            >
              Run
            </Button>
            <Button
              size="small"
              refused={file.looked ? t("It was looked through.") : refused}
              aria-label={t("Look through {0}", file.name)}
              onPress={() => asks({ to: "look", name: file.name })}
            >
              Look through
            </Button>
            <Button
              size="small"
              refused={refused}
              aria-label={t("Copy {0} into the part folder", file.name)}
              onPress={() => asks({ to: "keep", name: file.name, replaces: false })}
            >
              Copy
            </Button>
            <Button
              size="small"
              refused={refused}
              aria-label={t("Delete {0}…", file.name)}
              onPress={() => ask({ to: "delete", name: file.name })}
            >
              Delete
            </Button>
          </div>
        </li>
      ))}
    </ul>
  );
}
