import { useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { FileInfo } from "../wire/messages";
import { sizeText } from "./fileWords";
import { inFolder, parentOf } from "./folder";
import { useFiles } from "./useFiles";
import "./file-picker.css";

/** Chooses a file of the part folder. */
export function FilePicker() {
  const hands = useHands();
  const kept = useSnapshot("folder");
  const [folder, setFolder] = useState(kept?.name ?? "");
  const [mask, setMask] = useState("");
  const [looksBack, setLooksBack] = useState(false);
  const files = useFiles(folder);
  const close = () => hands.screen.open(null);
  const choose = async (file: FileInfo) => {
    if (file.folder) return setFolder(file.name);
    if (looksBack) return hands.screen.open({ kind: "versions", name: file.name });
    // Where a file is chosen, the next one is looked for (FS).
    if (folder !== kept?.name)
      await ask(worldOf(hands), { do: "folder", name: folder, mask: null });
    if (hands.screen.get().face === "full") {
      return hands.screen.open({
        kind: "command",
        letters: "FP",
        given: [file.name.split("/").at(-1) ?? ""],
      });
    }
    if (await ask(worldOf(hands), { do: "open", name: file.name })) close();
  };
  const shown = inFolder(files, folder, mask);
  return (
    <Sheet title={folder ? `Part folder / ${folder}` : "Part folder"} shape="wide" onClose={close}>
      <div className="files-head">
        <Field
          label="Mask"
          placeholder="part files; * for all"
          value={mask}
          onChange={setMask}
          first
        />
      </div>
      {looksBack && <p>Choose the file whose earlier versions are shown.</p>}
      <ListBox
        aria-label="Files"
        className="files"
        selectionMode="none"
        onAction={(key) => {
          if (key === "..") return setFolder(parentOf(folder));
          const file = files.find(({ name }) => name === key);
          if (file) void choose(file);
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
      <Button onPress={() => setLooksBack(!looksBack)}>
        {looksBack ? "Open a file" : "Versions…"}
      </Button>
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
