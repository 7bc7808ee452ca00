import { useEffect, useSyncExternalStore } from "react";
import { FileTrigger } from "react-aria-components";
import { useWords } from "../app/useWords";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { isOver, stageText, type Upload, type Uploads } from "./uploads";
import "./upload-list.css";

interface UploadListProps {
  uploads: Uploads;
  /** Uses a file that has come. One that was brought alone is used at once, unless it came late. */
  onUse: (name: string) => void;
  /** None is used before somebody says so. */
  asks?: boolean;
}

/** Files on their way into the part folder: how far each is, the question before one is replaced, Stop. */
export function UploadList({ uploads, onUse, asks = false }: UploadListProps) {
  const words = useWords();
  const list = useSyncExternalStore(uploads.list.watch, uploads.list.get);
  const [only] = list;
  const isAlone = list.length === 1 && only?.stage.is === "done" && !only.late && !asks;
  const alone = isAlone ? only.name : undefined;
  // biome-ignore lint/correctness/useExhaustiveDependencies: once, when it has come
  useEffect(() => {
    if (alone !== undefined) onUse(alone);
  }, [alone]);
  return (
    <ul className="uploads" aria-label={t("Uploads")} aria-live="polite">
      {list.map((upload) => (
        <li key={upload.id} className={`upload upload-${upload.stage.is}`}>
          <p className="upload-words">
            <b>{upload.name}</b> {stageText(upload, words)}
          </p>
          <UploadButtons upload={upload} uploads={uploads} onUse={onUse} />
        </li>
      ))}
    </ul>
  );
}

function UploadButtons({ upload, uploads, onUse }: UploadListProps & { upload: Upload }) {
  const { stage, name, id } = upload;
  if (stage.is === "asks") {
    return (
      <span className="upload-buttons">
        <Button onPress={() => stage.answer(false)}>Leave it</Button>
        <Button look="primary" onPress={() => stage.answer(true)}>
          Replace
        </Button>
      </span>
    );
  }
  if (stage.is === "done") {
    return (
      <Button aria-label={t("Open {0}", name)} onPress={() => onUse(name)}>
        Open
      </Button>
    );
  }
  if (isOver(upload)) return null;
  return (
    <Button aria-label={t("Stop sending {0}", name)} onPress={() => uploads.stop(id)}>
      Stop sending
    </Button>
  );
}

interface UploadButtonProps {
  uploads: Uploads;
  /** Below the part folder, where the files go. */
  folder: string;
  /** Endings of the names that are offered first, without the point. */
  endings?: readonly string[];
}

/** Chooses files of this computer and sends them into the part folder. */
export function UploadButton({ uploads, folder, endings }: UploadButtonProps) {
  const accepts = endings?.map((ending) => `.${ending}`);
  return (
    <FileTrigger
      allowsMultiple
      {...(accepts ? { acceptedFileTypes: accepts } : {})}
      onSelect={(files) => uploads.add(folder, [...(files ?? [])])}
    >
      <Button>Upload…</Button>
    </FileTrigger>
  );
}
