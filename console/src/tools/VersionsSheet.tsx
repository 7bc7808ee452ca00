import { useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useFetched } from "../app/useFetched";
import { fileAddress, restoreFile } from "../link/http";
import { FileText } from "../operator/FileText";
import { sizeText, timeText } from "../operator/fileWords";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { FileVersion } from "../wire/messages";

const none: readonly FileVersion[] = [];

/** What a file was before its last saves, and the way back to each. */
export function VersionsSheet({ name, onClose }: { name: string; onClose: () => void }) {
  const hands = useHands();
  const opened = useSnapshot("opened")?.name;
  const files = useSnapshot("files");
  const [looked, setLooked] = useState<number | null>(null);
  const versions = useFetched(`${fileAddress(name)}?versions`, none, files);
  const restore = async (version: FileVersion) => {
    try {
      await restoreFile(name, version.number);
      hands.screen.tell(`${name} is again what it was ${timeText(version.changed)}.`);
      if (opened === name) await ask(worldOf(hands), { do: "open", name });
    } catch (error) {
      hands.screen.tell((error as Error).message);
    }
  };
  return (
    <Sheet title={`Versions of ${name}`} onClose={onClose}>
      <p className="tool-words">
        What the file was before Kerf wrote over it, the last 20 times. The one that is brought back
        is a save as any other: what it takes the place of is kept too.
      </p>
      {versions.length === 0 && <p className="tail-empty">Kerf has not written over it yet.</p>}
      <ol className="versions" aria-label="Versions">
        {versions.map((version) => (
          <li key={version.number}>
            <span>{timeText(version.changed)}</span>
            <span className="versions-size">{sizeText(version.bytes)}</span>
            <Button
              size="small"
              aria-expanded={looked === version.number}
              onPress={() => setLooked(looked === version.number ? null : version.number)}
              aria-label={`Look at version ${version.number}`}
            >
              Look at it
            </Button>
            <Button
              size="small"
              onPress={() => void restore(version)}
              aria-label={`Bring version ${version.number} back`}
            >
              Bring back
            </Button>
            {looked === version.number && (
              <FileText
                address={`${fileAddress(name)}?version=${version.number}`}
                label={`Version ${version.number}`}
              />
            )}
          </li>
        ))}
      </ol>
    </Sheet>
  );
}
