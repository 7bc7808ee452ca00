import { useEffect, useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import { ask } from "../actions/ask";
import { copied, renamed } from "../actions/files";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { SaveAs } from "../editor/SaveAs";
import { download } from "../link/download";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { FileInfo } from "../wire/messages";
import { DeleteFile } from "./DeleteFile";
import { copyName, type FileUse, fileUses } from "./fileUses";
import { sizeText } from "./fileWords";
import { baseOf, inFolder, parentOf } from "./folder";
import { RecentFiles } from "./RecentFiles";
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
  const [mask, setMask] = useState("");
  const [use, setUse] = useState<FileUse>("open");
  const [asking, setAsking] = useState<string | null>(null);
  const files = useFiles(folder);
  const uploads = useUploads();
  // biome-ignore lint/correctness/useExhaustiveDependencies: once for each time that files are given
  useEffect(() => uploads.add(folder, given ?? []), [given]);
  const close = () => hands.screen.open(null);
  const open = async (name: string) => {
    // Where a file is chosen, the next one is looked for (FS).
    if (parentOf(name) !== kept?.name)
      await ask(worldOf(hands), { do: "folder", name: parentOf(name), mask: null });
    if (hands.screen.get().face === "full") {
      return hands.screen.open({ kind: "command", letters: "FP", given: [baseOf({ name })] });
    }
    if (await ask(worldOf(hands), { do: "open", name })) close();
  };
  const choose = ({ folder, name }: FileInfo) => {
    if (folder) return setFolder(name);
    if (use === "open") void open(name);
    else if (use === "download") download(name);
    else if (use === "versions") hands.screen.open({ kind: "versions", name });
    else setAsking(name);
  };
  const shown = inFolder(files, folder, mask);
  if (asking !== null)
    return <FileQuestion use={use} name={asking} onDone={() => setAsking(null)} />;
  return (
    <Sheet
      title={folder ? `Part folder / ${folder}` : "Part folder"}
      shape="wide"
      onClose={close}
      foot={
        <>
          <span className="files-hint">
            Upload brings files of this computer here, and so does dropping them on the page.
          </span>
          <Button onPress={() => hands.screen.open({ kind: "bin" })}>Bin…</Button>
          <UploadButton uploads={uploads} folder={folder} />
        </>
      }
    >
      <div className="files-head">
        <Field
          label="Mask"
          placeholder="part files; * for all"
          value={mask}
          onChange={setMask}
          first
        />
        <Choice label="A file that is chosen" options={fileUses} value={use} onChange={setUse} />
      </div>
      <RecentFiles onOpen={(name) => void open(name)} />
      <UploadList uploads={uploads} onUse={(name) => void open(name)} />
      <ListBox
        aria-label="Files"
        className="files"
        selectionMode="none"
        onAction={(key) => {
          if (key === "..") return setFolder(parentOf(folder));
          const file = files.find(({ name }) => name === key);
          if (file) choose(file);
        }}
        renderEmptyState={() => <p className="tail-empty">No file matches.</p>}
      >
        {folder && (
          <ListBoxItem id=".." className="files-row" textValue="up">
            ↑ Folder above
          </ListBoxItem>
        )}
        {shown.map((file) => (
          <FileRow key={file.name} file={file} />
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
      title={copies ? `Copy ${name}` : `Rename ${name}`}
      verb={copies ? "Copy" : "Rename"}
      first={copies ? copyName(name) : name}
      onSave={(to) => void go(to)}
      onCancel={onDone}
    />
  );
}

function FileRow({ file }: { file: FileInfo }) {
  const name = file.name.split("/").at(-1) ?? file.name;
  return (
    <ListBoxItem id={file.name} className="files-row" textValue={name}>
      <span className="files-name">
        {file.folder ? "▸ " : ""}
        {name}
      </span>
      <span className="files-header" title={file.header ?? undefined}>
        {file.header && (
          <b className="files-mark" role="img" aria-label="Its head tells about the job">
            !
          </b>
        )}
        {file.header?.split("\n")[0]}
      </span>
      <span className="files-size">{file.folder ? "" : sizeText(file.bytes)}</span>
      <span className="files-date">{new Date(file.changed * 1000).toLocaleDateString()}</span>
    </ListBoxItem>
  );
}
