//! The words that begin statements.

macro_rules! keywords {
    ($($name:ident $text:literal)*) => {
        /// The words that begin statements.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Keyword { $($name,)* }
        impl Keyword {
            /// Every one.
            pub(crate) const ALL: &[(&'static str, Self)] = &[$(($text, Self::$name),)*];
            /// The keyword of a word in capitals.
            fn exact(word: &[u8]) -> Option<Self> {
                $(if word == $text.as_bytes() { return Some(Self::$name); })*
                None
            }
        }
    };
}

keywords! {
    If "IF" On "ON" End "END" Goto "GOTO" Open "OPEN" Play "PLAY" Exit "EXIT" Gosub "GOSUB"
    Pause "PAUSE" Print "PRINT" Input "INPUT" Write "WRITE" Close "CLOSE" Shell "SHELL"
    EndAll "ENDALL" Return "RETURN" MsgBox "MSGBOX" Warning "WARNING" SetUsrVal "SETUSRVAL"
    GetUsrVal "GETUSRVAL" GetUsrPath "GETUSRPATH" GetAppPath "GETAPPPATH"
    SetUsrValClrd "SETUSRVALCLRD" GetUsrValClrd "GETUSRVALCLRD"
    SetSpindleStatus "SETSPINDLESTATUS" GetSpindleStatus "GETSPINDLESTATUS"
    GetPartFileName "GETPARTFILENAME"
}

/// The words that begin statements, for editors.
pub fn statement_words() -> impl Iterator<Item = &'static str> {
    Keyword::ALL.iter().map(|(word, _)| *word)
}

impl Keyword {
    /// The keyword of a word, in any case.
    pub(crate) fn find(word: &str) -> Option<Self> {
        let mut capitals = [0; 16];
        let capitals = capitals.get_mut(..word.len())?;
        capitals.copy_from_slice(word.as_bytes());
        capitals.make_ascii_uppercase();
        Self::exact(capitals)
    }
}
