import { useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";
import { fileAddress, forgetFile, getJson, restoreFile } from "../link/http";
import { sizeText, timeText } from "../operator/fileWords";
import { answersOf } from "../operator/folder";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { FileInfo, FileVersion } from "../wire/messages";
import { t } from "../words/words";

const none: readonly FileInfo[] = [];

/** Brings a file back as it was when it was deleted, and the sample answers that lay beside it. */
async function bringBack(name: string, bin: readonly FileInfo[]): Promise<void> {
  for (const one of [name, answersOf(name)]) {
    if (!bin.some((file) => file.name === one)) continue;
    const [last] = await getJson<FileVersion[]>(`${fileAddress(one)}?versions`);
    if (last) await restoreFile(one, last.number);
  }
}

/** Files that were deleted, the way back for each, and the way to be rid of them. */
export function BinSheet({ onClose }: { onClose: () => void }) {
  const { screen } = useHands();
  const changes = useSnapshot("files");
  const bin = useFetched("/api/files?bin", none, changes);
  const [asks, setAsks] = useState(false);
  const does = (work: Promise<void>) => work.catch((error: Error) => screen.tell(error.message));
  const empty = async () => {
    for (const { name } of bin) await does(forgetFile(name));
    setAsks(false);
  };
  if (asks) return <EmptyBin bin={bin} onEmpty={empty} onCancel={() => setAsks(false)} />;
  return (
    <Sheet
      title="Bin"
      onClose={onClose}
      foot={
        <Button
          refused={bin.length === 0 ? t("The bin is empty.") : undefined}
          onPress={() => setAsks(true)}
        >
          Empty the bin…
        </Button>
      }
    >
      <p className="tool-words">
        {t(
          "A file that is deleted is kept here, with what it was before, until the bin is emptied or newer versions of other files need the room.",
        )}
      </p>
      {bin.length === 0 && <p className="tail-empty">{t("Nothing was deleted.")}</p>}
      <ol className="versions" aria-label={t("Deleted files")}>
        {bin.map(({ name, bytes, changed }) => (
          <li key={name} className="list-line">
            <span>{name}</span>
            <span className="versions-size">{`${sizeText(bytes)}, ${timeText(changed)}`}</span>
            <Button
              size="small"
              aria-label={t("Bring back {0}", name)}
              onPress={() => void does(bringBack(name, bin))}
            >
              Bring back
            </Button>
          </li>
        ))}
      </ol>
    </Sheet>
  );
}

interface EmptyBinProps {
  bin: readonly FileInfo[];
  onEmpty: () => void;
  onCancel: () => void;
}

/** Asks before what is in the bin is lost, and says what that is. */
function EmptyBin({ bin, onEmpty, onCancel }: EmptyBinProps) {
  const names = bin.map(({ name }) => name).join(", ");
  return (
    <Sheet
      title="Empty the bin?"
      shape="question"
      onClose={onCancel}
      foot={
        <>
          <Button size="large" data-first onPress={onCancel}>
            Cancel
          </Button>
          <Button size="large" look="primary" onPress={onEmpty}>
            Empty the bin
          </Button>
        </>
      }
    >
      <p className="question-text">
        {t("{0}: lost for good, with every version that was kept of them.", names)}
      </p>
    </Sheet>
  );
}
