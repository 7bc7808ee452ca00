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
import { t } from "../words/words";

const none: readonly FileVersion[] = [];

/** Lists the versions of a file from before its last saves, with the way back to each. */
export function VersionsSheet({ name, onClose }: { name: string; onClose: () => void }) {
  const hands = useHands();
  const opened = useSnapshot("opened")?.name;
  const files = useSnapshot("files");
  const [looked, setLooked] = useState<number | null>(null);
  const versions = useFetched(`${fileAddress(name)}?versions`, none, files);
  const restore = async (version: FileVersion) => {
    try {
      await restoreFile(name, version.number);
      hands.screen.tell(t("{0} is again what it was {1}.", name, timeText(version.changed)));
      if (opened === name) await ask(worldOf(hands), { do: "open", name });
    } catch (error) {
      hands.screen.tell((error as Error).message);
    }
  };
  return (
    <Sheet title={t("Versions of {0}", name)} onClose={onClose}>
      <p className="tool-words">
        {t(
          "What the file was before Kerf wrote over it, the last 20 times. The one that is brought back is a save as any other: what it takes the place of is kept too.",
        )}
      </p>
      {versions.length === 0 && (
        <p className="tail-empty">{t("Kerf has not written over it yet.")}</p>
      )}
      <ol className="versions" aria-label={t("Versions")}>
        {versions.map((version) => (
          <li key={version.number} className="list-line">
            <span>{timeText(version.changed)}</span>
            <span className="versions-size">{sizeText(version.bytes)}</span>
            <Button
              size="small"
              aria-expanded={looked === version.number}
              onPress={() => setLooked(looked === version.number ? null : version.number)}
              aria-label={t("Look at version {0}", version.number)}
            >
              Look at it
            </Button>
            <Button
              size="small"
              onPress={() => void restore(version)}
              aria-label={t("Bring version {0} back", version.number)}
            >
              Bring back
            </Button>
            {looked === version.number && (
              <FileText
                address={`${fileAddress(name)}?version=${version.number}`}
                label={t("Version {0}", version.number)}
              />
            )}
          </li>
        ))}
      </ol>
    </Sheet>
  );
}
