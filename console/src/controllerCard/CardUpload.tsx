import { useState } from "react";
import { useSnapshot } from "../app/context";
import { useFiles } from "../operator/useFiles";
import { Button } from "../ui/Button";
import { Pick } from "../ui/Pick";
import type { CardAct } from "../wire/messages";
import { t } from "../words/words";
import { goesOnCard } from "./card";

interface CardUploadProps {
  refused: string | undefined;
  asks: (task: CardAct) => void;
}

/** Puts a file of the part folder on the card; that which is open stands first. */
export function CardUpload({ refused, asks }: CardUploadProps) {
  const folder = useSnapshot("folder")?.name ?? "";
  const opened = useSnapshot("opened")?.name;
  const files = useFiles(folder).filter((file) => !file.folder && goesOnCard(file.name));
  const names = files.map(({ name }) => name);
  const first = opened !== undefined && goesOnCard(opened) ? [opened] : [];
  const all = [...new Set([...first, ...names])];
  const [chosen, choose] = useState<string>();
  const file = chosen ?? all[0];
  if (file === undefined) {
    return <p role="note">{t("The part folder has no file that goes on a card.")}</p>;
  }
  return (
    <div className="controller-card-upload">
      <Pick
        label="File of the part folder"
        labelled
        options={all.map((name) => ({ value: name, words: name }))}
        value={file}
        onChange={choose}
      />
      <Button refused={refused} onPress={() => asks({ to: "upload", file, replaces: false })}>
        Put it on the card
      </Button>
    </div>
  );
}
