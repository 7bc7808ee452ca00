//! The fields that the head of a part file tells about its job.
//!
//! A header is the first block of comment lines when it fills in fields: `'Material: birch, 18 mm`.
//! The tool that writes headers (TH) uses these fields; files that people head by hand count as well.

/// The fields of a header.
const FIELDS: [&str; 13] = [
    "contact",
    "designer",
    "file",
    "date",
    "restrictions",
    "material",
    "bit",
    "tool",
    "units",
    "zero",
    "offset",
    "notes",
    "run",
];

/// The header of a part file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// Its text, without the signs of comments.
    pub text: String,
}

impl Header {
    /// The header of a part file; nothing when its head is no comment or fills in no field.
    pub fn read(text: &str) -> Option<Self> {
        let lines = text.lines().map(str::trim).skip_while(|line| line.is_empty());
        let head: Vec<&str> = lines
            .map_while(|line| line.strip_prefix('\''))
            .map(|line| line.trim_start_matches('\'').trim())
            .collect();
        let fills = head.iter().any(|line| is_field(line));
        fills.then(|| Self { text: head.join("\n") })
    }
}

fn is_field(line: &str) -> bool {
    let Some((name, value)) = line.split_once(':') else { return false };
    let first = name.split_whitespace().next().unwrap_or_default();
    !value.trim().is_empty() && FIELDS.iter().any(|field| field.eq_ignore_ascii_case(first))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_comments_are_a_header_when_they_fill_in_fields() {
        let header = |text: &str| Header::read(text).map(|h| h.text);
        let file = "\n'Contact: Ann\n'Bit diameter: .25\n' \nMX,1\n'Notes: late";
        assert_eq!(header(file).as_deref(), Some("Contact: Ann\nBit diameter: .25\n"));
        for none in ["", "MX,1\n'Notes: x", "'a comment\nMX,1", "'Notes:\nMX,1", "'see: that\n"] {
            assert_eq!(header(none), None, "{none}");
        }
    }
}
