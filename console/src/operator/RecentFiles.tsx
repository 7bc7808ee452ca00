import { useState } from "react";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { recentFiles } from "./recent";
import { Thumbnail } from "./Thumbnail";

/** The files that were opened last, one press each. */
export function RecentFiles({ onOpen }: { onOpen: (name: string) => void }) {
  const [names] = useState(recentFiles);
  if (names.length === 0) return null;
  return (
    <section className="files-recent" aria-label={t("Opened last")}>
      <span>{t("Opened last")}</span>
      {names.map((name) => (
        <Button key={name} size="small" onPress={() => onOpen(name)}>
          <Thumbnail name={name} />
          {name}
        </Button>
      ))}
    </section>
  );
}
