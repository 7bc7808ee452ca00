import { useEffect, useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { FileInfo } from "../wire/messages";
import { sizeText } from "./fileWords";
import { baseOf, inFolder, parentOf } from "./folder";
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
  const [looksBack, setLooksBack] = useState(false);
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
    if (looksBack) return hands.screen.open({ kind: "versions", name });
    void open(name);
  };
  const shown = inFolder(files, folder, mask);
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
          <Button onPress={() => setLooksBack(!looksBack)}>
            {looksBack ? "Open a file" : "Versions…"}
          </Button>
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
      </div>
      <UploadList uploads={uploads} onUse={(name) => void open(name)} />
      {looksBack && <p>Choose the file whose earlier versions are shown.</p>}
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
