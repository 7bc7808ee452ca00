//! The SQLite file: how it is opened, what it says when something is wrong.

use super::JournalError;
use kerf_files::private;
use rusqlite::{Connection, ErrorCode, OpenFlags, ffi};
use std::path::Path;
use std::time::Duration;

/// Version of the tables. In the first one, what the machine says of itself is among the values.
const VERSION: i64 = 2;

/// The version before.
const FIRST: i64 = 1;

/// Longest wait for another process that writes.
const PATIENCE: Duration = Duration::from_secs(5);

const TABLES: &str = "
    CREATE TABLE fact    (key PRIMARY KEY, text NOT NULL, sum INTEGER NOT NULL) WITHOUT ROWID;
    CREATE TABLE value   (key PRIMARY KEY, text NOT NULL, sum INTEGER NOT NULL) WITHOUT ROWID;
    CREATE TABLE step    (key PRIMARY KEY, text NOT NULL, sum INTEGER NOT NULL) WITHOUT ROWID;
    CREATE TABLE content (key PRIMARY KEY, text NOT NULL, sum INTEGER NOT NULL);
    CREATE TABLE history (key PRIMARY KEY, text NOT NULL, sum INTEGER NOT NULL) WITHOUT ROWID;
    PRAGMA user_version = 2;";

/// Way in which a database is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Access {
    /// To change it.
    Write,
    /// Nothing is changed, not even in a folder that cannot be written.
    Look,
}

/// Error that the database reports, or a fault in a row of it.
#[derive(Debug)]
pub(super) enum Trouble {
    /// SQLite says so.
    Sql(rusqlite::Error),
    /// A row or the whole does not fit its check number.
    Damaged(String),
    /// Its tables are of a later version.
    Newer,
}

impl From<rusqlite::Error> for Trouble {
    fn from(error: rusqlite::Error) -> Self {
        Self::Sql(error)
    }
}

impl Trouble {
    /// The same of a file, in words for the user.
    pub(super) fn at(self, file: &Path) -> JournalError {
        let path = file.to_owned();
        let error = match self {
            Self::Damaged(what) => return JournalError::Damaged { path, what },
            Self::Newer => return JournalError::Newer { path },
            Self::Sql(error) => error,
        };
        let why = error.to_string();
        let Some(failure) = error.sqlite_error() else { return JournalError::Other { path, why } };
        match failure.code {
            ErrorCode::DiskFull => JournalError::Full { path },
            ErrorCode::SystemIoFailure if no_room(failure.extended_code) => {
                JournalError::Full { path }
            }
            ErrorCode::ReadOnly | ErrorCode::CannotOpen | ErrorCode::PermissionDenied => {
                JournalError::ReadOnly { path, why }
            }
            ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase => {
                JournalError::Damaged { path, what: why }
            }
            _ => JournalError::Other { path, why },
        }
    }
}

/// A limit on the size of files looks like a failing write.
const fn no_room(code: i32) -> bool {
    matches!(
        code,
        ffi::SQLITE_IOERR_WRITE
            | ffi::SQLITE_IOERR_FSYNC
            | ffi::SQLITE_IOERR_TRUNCATE
            | ffi::SQLITE_IOERR_SHMSIZE
    )
}

/// Opens the file; with tables in it when it may be changed.
pub(super) fn open(file: &Path, access: Access) -> Result<Connection, Trouble> {
    let connection = match access {
        Access::Write => {
            // SQLite makes the files beside it as it finds this one.
            private::make(file);
            Connection::open(file)?
        }
        Access::Look => look(file)?,
    };
    connection.busy_timeout(PATIENCE)?;
    if access == Access::Write {
        connection.pragma_update(None, "journal_mode", "WAL")?;
        synchronous(&connection, true)?;
    }
    sound(&connection)?;
    match (version(&connection)?, access) {
        (0, Access::Write) => connection
            .execute_batch(&format!("BEGIN IMMEDIATE; {TABLES} COMMIT;"))
            .or_else(|error| made_meanwhile(&connection, error))?,
        (FIRST | VERSION, _) | (0, Access::Look) => {}
        _ => return Err(Trouble::Newer),
    }
    Ok(connection)
}

/// Two processes that open a new file at once: one of them makes the tables.
fn made_meanwhile(connection: &Connection, error: rusqlite::Error) -> Result<(), Trouble> {
    let made = version(connection)? == VERSION;
    if !connection.is_autocommit() {
        connection.execute_batch("ROLLBACK")?;
    }
    if made { Ok(()) } else { Err(error.into()) }
}

/// Opens the file to read it. Where the folder cannot be written, readers cannot tell each other of themselves:
/// then the file is read as it is.
pub(super) fn look(file: &Path) -> Result<Connection, Trouble> {
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY;
    let usual = Connection::open_with_flags(file, flags);
    let readable =
        |c: &Connection| c.query_row("SELECT count(*) FROM sqlite_schema", [], |_| Ok(()));
    match usual.and_then(|connection| readable(&connection).map(|()| connection)) {
        Err(error)
            if matches!(
                error.sqlite_error_code(),
                Some(ErrorCode::CannotOpen | ErrorCode::ReadOnly)
            ) =>
        {
            Ok(as_it_is(file)?)
        }
        opened => Ok(opened?),
    }
}

/// The file without its write-ahead file. Nothing is changed or made beside it.
pub(super) fn as_it_is(file: &Path) -> rusqlite::Result<Connection> {
    let name = file.to_string_lossy().replace('%', "%25").replace('?', "%3f").replace('#', "%23");
    let uri = format!("file:{name}?immutable=1");
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI;
    Connection::open_with_flags(uri, flags)
}

/// Checks that the pages of the file fit together.
pub(super) fn sound(connection: &Connection) -> Result<(), Trouble> {
    let found: String = connection.query_row("PRAGMA quick_check(1)", [], |row| row.get(0))?;
    match found.as_str() {
        "ok" => Ok(()),
        _ => Err(Trouble::Damaged("its pages do not fit together".into())),
    }
}

/// Tells a file that has something to read.
pub(super) fn has_tables(connection: &Connection) -> Result<bool, Trouble> {
    Ok(version(connection)? != 0)
}

/// Tells a file in which what the machine says of itself is not among the values.
pub(super) fn has_facts_apart(connection: &Connection) -> Result<bool, Trouble> {
    Ok(version(connection)? != FIRST)
}

/// The file has it apart from now on: an earlier Kerf would look for it among the values.
pub(super) fn facts_are_apart(connection: &Connection) -> Result<(), Trouble> {
    Ok(connection.pragma_update(None, "user_version", VERSION)?)
}

fn version(connection: &Connection) -> rusqlite::Result<i64> {
    connection.pragma_query_value(None, "user_version", |row| row.get(0))
}

/// Sets whether each commit waits for the disk.
pub(super) fn synchronous(connection: &Connection, each: bool) -> Result<(), Trouble> {
    Ok(connection.pragma_update(None, "synchronous", if each { "FULL" } else { "NORMAL" })?)
}

/// Puts every change into the file itself and empties the write-ahead file, unless somebody reads at this moment; whether
/// it was done.
pub(super) fn checkpoint(connection: &Connection) -> Result<bool, Trouble> {
    connection.busy_timeout(Duration::ZERO)?;
    let busy = connection.query_row("PRAGMA wal_checkpoint(TRUNCATE)", [], |row| row.get(0));
    connection.busy_timeout(PATIENCE)?;
    Ok(busy.map(|busy: i64| busy == 0)?)
}

/// Writes a copy of the whole into a new file.
pub(super) fn copy(connection: &Connection, to: &Path) -> Result<(), Trouble> {
    private::make(to);
    connection.execute("VACUUM INTO ?1", [to.to_string_lossy()])?;
    Ok(())
}
