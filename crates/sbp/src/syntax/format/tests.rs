use super::format;
use crate::syntax::read;
use crate::syntax::reader::shown::node;
use crate::syntax::tree::Node;

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(format(text), expected, "{text:?}");
    assert_eq!(format(expected), expected, "formatting twice: {text:?}");
}

/// Formatting keeps every node and is done after one round.
#[track_caller]
pub(crate) fn keeps_meaning(text: &str) {
    let once = format(text);
    assert_eq!(format(&once), once, "formatting twice\n{text:?}");
    let (before, after) = (read("".into(), text.as_bytes()), read("".into(), once.as_bytes()));
    // Blanks without a line end behind them are no line any more.
    let count = after.lines.len();
    assert!(
        before.lines[count..].iter().all(|line| line.node == Node::Blank),
        "{text:?}\n{once:?}"
    );
    for index in 0..count {
        let bad = matches!(before.lines[index].node, Node::Bad);
        if !bad {
            assert_eq!(node(&before, index), node(&after, index), "line {}\n{once}", index + 1);
        }
    }
}

#[test]
fn commands() {
    check("mx,1", "MX,1");
    check("m2  3, 4 ,", "M2,3,4");
    check("M2 , 4.2", "M2,,4.2");
    check("M3,,,.50 'up", "M3,,,.50 'up");
    check("\t jz, .5", "\t JZ,.5");
    check("M2", "M2");
    check("zx,", "ZX");
    check("m2 &a + 1, ( 2*3 )", "M2,&a + 1,( 2*3 )");
    check("m3 , &Long_Name,,", "M3,,&Long_Name");
    check("fp  my part.sbp, 1 ,,2", "FP,my part.sbp,1,,2");
}

#[test]
fn statements() {
    check("&a=5", "&a = 5");
    check("  $Name:=\"x  y\"  'c", "  $Name := \"x  y\"  'c");
    check("&a  =", "&a =");
    check("vv &a=5", "VV,&a = 5");
    check("&a =\"a = b\"", "&a = \"a = b\"");
    check("if(&a=1)then   m2 , 5", "IF (&a=1) THEN M2,,5");
    check("if(&a=1)then   mx  5", "IF (&a=1) THEN MX,5");
    check("If  &a = 1  Then  goto  Out", "IF &a = 1 THEN GOTO Out");
    check("if &a then &b=3", "IF &a THEN &b = 3");
    check("goto Out:", "GOTO Out");
    check("on inp( &t ,1 )goto Hit", "ON INP(&t,1) GOTO Hit");
    check("On Input(3,1)", "ON INPUT(3,1)");
    check("pause,2", "PAUSE 2");
    check("pause  2  seconds please", "PAUSE 2 seconds please");
    check("pause .25,,   ??needed 'x", "PAUSE .25,,   ??needed 'x");
    check("pause", "PAUSE");
    check("pause until 5 , 1", "PAUSE UNTIL 5,1");
    check("print\"a\",\"b\";", "PRINT \"a\",\"b\";");
    check("print; \"a\"", "PRINT; \"a\"");
    check("write #1;  \"a\"", "WRITE #1;  \"a\"");
    check("msgbox (Do it?, yesno, t)", "MSGBOX(Do it?, yesno, t)");
    check("input \"x\" &a", "INPUT \"x\" &a");
    check("open \"f\" for output as #1", "OPEN \"f\" for output as #1");
    check("getusrval &v", "GetUsrVal &v");
    check("end  of job", "END of job");
    check("end all", "END ALL");
    check("exit  shopbot", "EXIT SHOPBOT");
    check("warning off", "WARNING OFF");
    check("c# 90", "C#,90");
    check("cn, 90", "CN,90");
    check("c9", "C9");
    check("g1x1 f60 'cut", "g1x1 f60 'cut");
}

#[test]
fn layout() {
    check("   Start :  'here  ", "Start:  'here");
    check("  SECOND  PLUNGE:", "SECOND  PLUNGE:");
    check("MX,2'tight", "MX,2 'tight");
    check("   'only text  ", "   'only text");
    check("rem  x ", "rem  x");
    check("   \n\n\tMX,1  \n", "\n\n\tMX,1\n");
    check("mx,1\r\nmy,2\rmz,3\n", "MX,1\r\nMY,2\rMZ,3\n");
    check("\u{feff}mx,1", "\u{feff}MX,1");
    check("mx 1 my 2  ", "mx 1 my 2  ");
    check("", "");
    check("mx\0", "mx\0");
}

#[test]
fn comments_keep_their_column() {
    // Code that grows or shrinks moves none of them.
    check(
        "ms, 1.5 , .5   'slow\n&a=-1          'deep",
        "MS,1.5,.5      'slow\n&a = -1        'deep",
    );
    // Lines without a comment lie between; a block is over where the column is another.
    check(
        "mx,1   'a\n\nzx\n'text\nmx, 2  'b\nmx, 3 'c",
        "MX,1   'a\n\nZX\n'text\nMX,2   'b\nMX,3 'c",
    );
    // The longest line leaves the first free column.
    check("&a=1 'a\n&bb=1'b", "&a = 1  'a\n&bb = 1 'b");
    check("&a=1  'a\n&bb=1 'b", "&a = 1  'a\n&bb = 1 'b");
    check("mx,1'a\nmx,2'b", "MX,1 'a\nMX,2 'b");
    // Labels and letters beyond ASCII count by characters.
    check(" A :   'a\n&ä=\"é\" 'b", "A:       'a\n&ä = \"é\" 'b");
    // A comment behind a tab stands in no column.
    check("mx, 1\t'a\nmx, 2\t'b", "MX,1\t'a\nMX,2\t'b");
    check("mx, 1  'a\nm2\t1,2'b\nmx, 2  'c", "MX,1  'a\nM2,1,2 'b\nMX,2  'c");
}

mod properties {
    use super::{format, keeps_meaning};
    use crate::syntax::reader::properties::{config, lines, statements};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(config(1000))]

        #[test]
        fn any_program_keeps_its_meaning(
            text in prop::collection::vec(prop_oneof![lines(), statements(), tidy()], 1..5)
        ) {
            keeps_meaning(&text.join("\n"));
        }
    }

    proptest! {
        #![proptest_config(config(1000))]

        /// Comments that stand in one column stand in one column afterwards, in that one where the code leaves it free.
        #[test]
        fn a_block_of_comments_keeps_one_column(
            codes in prop::collection::vec(prop::sample::select(CODES), 2..6),
            column in 1..30usize,
        ) {
            let column = codes.iter().map(|code| code.len()).fold(column, usize::max);
            let lines: Vec<String> = codes.iter().map(|code| format!("{code:column$}'x")).collect();
            let once = format(&lines.join("\n"));
            let places: Vec<_> = once.lines().map(|line| line.find('\'')).collect();
            prop_assert!(places.windows(2).all(|pair| pair[0] == pair[1]), "{once}");
            let code_of = |line: &str| line.trim_end_matches("'x").trim_end().len();
            let longest = once.lines().map(code_of).max().unwrap_or(0);
            prop_assert_eq!(places[0], Some(column.max(longest + 1)), "{}", once);
        }
    }

    /// Code that becomes longer, shorter, or stays.
    const CODES: &[&str] = &[
        "mx, 1",
        "M3,1,2,3",
        "&a=1",
        "&Long_Name:=5*2",
        "if &a=1 then m2  5 , 6 ,",
        "zx,,",
        "pause 2",
        "print  \"a\"",
        "fp, part.sbp , 1",
        "GOTO A",
        "  end",
        "on inp( 1,1 )goto A",
        "cn, 90",
        "Start :",
    ];

    /// Lines that can be read, in odd spellings.
    fn tidy() -> impl Strategy<Value = String> {
        let value = prop_oneof![
            Just(""),
            Just("1"),
            Just("-.5"),
            Just("&a + 1"),
            Just("(&b*2)"),
            Just("%(1)"),
            Just("\"t,'x\""),
        ];
        let comma = prop_oneof![Just(","), Just(" , "), Just(",\t")];
        let word = prop_oneof![
            Just("mx"),
            Just("M3 "),
            Just("j2\t"),
            Just("fp "),
            Just("if &a=1 then mx"),
            Just("print "),
            Just("write #1;"),
            Just("on inp(1,2) m3 "),
            Just("shell,"),
            Just("&x :="),
            Just("msgbox ("),
            Just("input \"x\";"),
            Just("pause "),
            Just("C# "),
            Just("cn"),
            Just("  end "),
        ];
        (
            word,
            prop::collection::vec((comma, value), 0..5),
            prop_oneof![Just(""), Just("'c "), Just("  'c")],
        )
            .prop_map(|(word, fields, comment)| {
                let fields: String = fields.iter().map(|(c, v)| format!("{c}{v}")).collect();
                format!("{word}{fields}{comment}")
            })
    }
}
