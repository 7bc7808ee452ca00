import { useEffect, useState } from "react";
import { useHands } from "../app/context";
import { sendFile } from "../link/send";
import { t } from "../words/words";
import { Uploads } from "./uploads";

/** Uploads that stand on this part of the page: what is not over ends with it, and the person is told. */
export function useUploads(): Uploads {
  const { link, screen } = useHands();
  const [uploads] = useState(() => {
    const moves = () => link.shown.get().snapshot?.machine.state === "running";
    return new Uploads({ send: sendFile, moves });
  });
  useEffect(
    () => () => {
      for (const name of uploads.close())
        screen.tell(t("{0} is not uploaded: its list was closed before.", name));
    },
    [uploads, screen],
  );
  return uploads;
}
