//! Questions to a board. Answers are not assured, so each question is asked until it is answered.

/// Time after which an answer counts as lost, seconds; doubled each time.
const PATIENCE_S: f64 = 0.06;
/// Times that a question is asked.
const TRIES: u32 = 7;

/// Kinds of questions; a question that is there is not asked a second time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The clock since power-up.
    Uptime,
    /// The state of the configuration.
    Config,
    /// Steps of a motor.
    Position(usize),
    /// A latch is to be triggered.
    Latch(usize),
    /// Level and last look of a switch.
    Switch(usize),
    /// A register of a motor driver behind a wire.
    Register(usize, u8),
    /// Bytes of a chip behind a select.
    Transfer(usize),
}

impl About {
    /// The board's name for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Uptime => "get_uptime",
            Self::Config => "get_config",
            Self::Position(_) => "stepper_get_position",
            Self::Latch(_) => "trsync_trigger",
            Self::Switch(_) => "endstop_query_state",
            Self::Register(..) => "tmcuart_send",
            Self::Transfer(_) => "spi_transfer",
        }
    }
}

#[derive(Clone, Debug)]
struct Question {
    about: About,
    command: Vec<u8>,
    ask_s: f64,
    tries: u32,
}

/// Questions that wait for their answers.
#[derive(Clone, Debug, Default)]
pub struct Questions(Vec<Question>);

impl Questions {
    /// Asks a question from now on.
    pub fn ask(&mut self, about: About, command: Vec<u8>) {
        self.answered(about);
        self.0.push(Question { about, command, ask_s: f64::NEG_INFINITY, tries: 0 });
    }

    /// A question was answered; false where it was not asked.
    pub fn answered(&mut self, about: About) -> bool {
        let before = self.0.len();
        self.0.retain(|question| question.about != about);
        self.0.len() < before
    }

    /// A question waits for its answer.
    pub fn has(&self, about: impl Fn(About) -> bool) -> bool {
        self.0.iter().any(|question| about(question.about))
    }

    /// Nothing is to be known any more.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Commands to be sent now; the error is a question that was asked in vain.
    pub fn due(&mut self, now_s: f64) -> Result<Vec<Vec<u8>>, About> {
        let mut commands = Vec::new();
        for question in self.0.iter_mut().filter(|question| question.ask_s <= now_s) {
            if question.tries >= TRIES {
                return Err(question.about);
            }
            question.ask_s = now_s + PATIENCE_S * f64::from(1 << question.tries);
            question.tries += 1;
            commands.push(question.command.clone());
        }
        Ok(commands)
    }

    /// Moment at which the next one is asked.
    pub fn due_s(&self) -> f64 {
        self.0.iter().map(|question| question.ask_s).fold(f64::INFINITY, f64::min)
    }
}
