import { useEffect, useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import { isUnsaved, unsaved } from "../actions/draw";
import { copied, renamed } from "../actions/files";
import { fileNamed } from "../actions/replace";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { SaveAs } from "../editor/SaveAs";
import { download } from "../link/download";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { FileInfo } from "../wire/messages";
import { language, t } from "../words/words";
import { DeleteFile } from "./DeleteFile";
import { copyName, type FileUse, fileUses } from "./fileUses";
import { sizeText } from "./fileWords";
import { baseOf, listed, parentOf } from "./folder";
import { kindWord, openDrawing, openToRun } from "./openFile";
import { openOther } from "./openOther";
import { RecentFiles } from "./RecentFiles";
import { Thumbnail } from "./Thumbnail";
import { UploadButton, UploadList } from "./UploadList";
import { useFiles } from "./useFiles";
import { useUploads } from "./useUploads";
import "./file-picker.css";

interface FilePickerProps {
  /** Files of this computer that go into the part folder. */
  given?: readonly File[] | undefined;
}

/** Chooses a file of the part folder, and brings files into it. */
export function FilePicker({ given }: FilePickerProps) {
  const hands = useHands();
  const kept = useSnapshot("folder");
  const [folder, setFolder] = useState(kept?.name ?? "");
  const [word, setWord] = useState("");
  const [use, setUse] = useState<FileUse>("open");
  const [asking, setAsking] = useState<string | null>(null);
  const [lost, setLost] = useState<string | null>(null);
  const files = useFiles(folder, word.trim());
  const uploads = useUploads();
  // biome-ignore lint/correctness/useExhaustiveDependencies: once for each time that files are given
  useEffect(() => uploads.add(folder, given ?? []), [given]);
  const close = () => hands.screen.open(null);
  const open = async (name: string) => {
    const file = files.find((file) => file.name === name) ?? (await fileNamed(name));
    if (file?.opens === null) return void openOther(hands, file, kept?.name ?? "");
    if (file?.opens !== "drawing") return void openToRun(hands, name, kept?.name ?? "");
    if (isUnsaved(worldOf(hands))) setLost(name);
    else void openDrawing(hands, name);
  };
  const choose = ({ folder, name }: FileInfo) => {
    if (folder) return setFolder(name);
    if (use === "open") void open(name);
    else if (use === "download") download(name);
    else if (use === "versions") hands.screen.open({ kind: "versions", name });
    else setAsking(name);
  };
  const shown = listed(files, word.trim());
  if (lost !== null) return <DrawingLost name={lost} onDone={() => setLost(null)} />;
  if (asking !== null)
    return <FileQuestion use={use} name={asking} onDone={() => setAsking(null)} />;
  return (
    <Sheet
      about="Open a file"
      title={folder ? t("Part folder / {0}", folder) : t("Part folder")}
      shape="wide"
      onClose={close}
      foot={
        <>
          <span className="files-hint">
            {t("Upload brings files of this computer here, and so does dropping them on the page.")}
          </span>
          <Button onPress={() => hands.screen.open({ kind: "todo" })}>Jobs to do…</Button>
          <Button onPress={() => hands.screen.open({ kind: "history" })}>History…</Button>
          <Button onPress={() => hands.screen.open({ kind: "bin" })}>Bin…</Button>
          <UploadButton uploads={uploads} folder={folder} />
        </>
      }
    >
      <div className="files-head">
        <Field
          label="Search"
          placeholder="in all folders; *.log for other files"
          value={word}
          onChange={setWord}
          first
        />
        <Choice label="A file that is chosen" options={fileUses} value={use} onChange={setUse} />
      </div>
      <RecentFiles onOpen={(name) => void open(name)} />
      <UploadList uploads={uploads} onUse={(name) => void open(name)} />
      <ListBox
        aria-label={t("Files")}
        className="files"
        selectionMode="none"
        onAction={(key) => {
          if (key === "..") return setFolder(parentOf(folder));
          const file = files.find(({ name }) => name === key);
          if (file) choose(file);
        }}
        renderEmptyState={() => <p className="tail-empty">{t("No file matches.")}</p>}
      >
        {folder && word.trim() === "" && (
          <ListBoxItem id=".." className="files-row" textValue={t("↑ Folder above")}>
            {t("↑ Folder above")}
          </ListBoxItem>
        )}
        {shown.map((file) => (
          <FileRow key={file.name} file={file} whole={word.trim() !== ""} />
        ))}
      </ListBox>
    </Sheet>
  );
}

interface FileQuestionProps {
  use: FileUse;
  name: string;
  onDone: () => void;
}

/** Asks what has to be known before a file is copied, renamed or deleted. */
function FileQuestion({ use, name, onDone }: FileQuestionProps) {
  const hands = useHands();
  if (use === "delete") return <DeleteFile name={name} onDone={onDone} />;
  const copies = use === "copy";
  const go = async (to: string) => {
    const does = copies ? copied : renamed;
    if (await does(worldOf(hands), name, to)) hands.screen.open({ kind: "files" });
    onDone();
  };
  return (
    <SaveAs
      title={copies ? t("Copy {0}", name) : t("Rename {0}", name)}
      verb={copies ? t("Copy") : t("Rename")}
      first={copies ? copyName(name) : name}
      onSave={(to) => void go(to)}
      onCancel={onDone}
    />
  );
}

/** Asks before a drawing takes the place of one that is not saved. */
function DrawingLost({ name, onDone }: { name: string; onDone: () => void }) {
  const hands = useHands();
  return (
    <Sheet
      title={t("Open {0}?", name)}
      shape="question"
      onClose={onDone}
      foot={
        <>
          <Button size="large" data-first onPress={onDone}>
            Cancel
          </Button>
          <Button size="large" look="primary" onPress={() => void openDrawing(hands, name)}>
            Open
          </Button>
        </>
      }
    >
      <p className="question-text">{unsaved}</p>
    </Sheet>
  );
}

function FileRow({ file, whole }: { file: FileInfo; whole: boolean }) {
  const base = baseOf(file);
  return (
    <ListBoxItem id={file.name} className="files-row" textValue={base}>
      {file.folder ? (
        <span className="files-folder" aria-hidden="true">
          ▸
        </span>
      ) : (
        <Thumbnail name={file.name} changed={file.changed} />
      )}
      <span className="files-name">{whole ? file.name : base}</span>
      <span className="files-kind">{kindWord(file)}</span>
      <span className="files-header" title={file.header ?? undefined}>
        {file.header && (
          <b className="files-mark" role="img" aria-label={t("Its head tells about the job")}>
            !
          </b>
        )}
        {file.header?.split("\n")[0]}
      </span>
      <span className="files-size">{file.folder ? "" : sizeText(file.bytes)}</span>
      <span className="files-date">
        {new Date(file.changed * 1000).toLocaleDateString(language)}
      </span>
    </ListBoxItem>
  );
}
