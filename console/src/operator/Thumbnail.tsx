import { fileAddress } from "../link/http";

interface ThumbnailProps {
  name: string;
  /** Time of the file's last change, so that the picture of another content is not shown. */
  changed?: number;
}

/** A small picture of a drawing, or of a file's tool path; empty where that was never previewed. */
export function Thumbnail({ name, changed }: ThumbnailProps) {
  const version = changed === undefined ? "" : `=${changed}`;
  return (
    <img
      className="thumbnail"
      src={`${fileAddress(name)}?thumb${version}`}
      alt=""
      loading="lazy"
      width={36}
      height={36}
    />
  );
}
