//! The upper part of the text: the joints.

use glam::Vec3;
use skeleton::{Channel, JointId, Skeleton, SkeletonError};

use super::{Error, ErrorKind, Warning, WarningKind};
use crate::encoding::not_a_text;
use crate::error::is_conflict_mark;
use crate::snippet::printable_start;
use crate::source::{LONGEST_WORD, Place, Source, is_blank};
use crate::warning::warn;
use crate::{Snippet, words};

/// Reads everything from `HIERARCHY` up to `MOTION`, which is taken too.
pub(super) fn read(source: &mut Source, warnings: &mut Vec<Warning>) -> Result<Skeleton, Error> {
    if !source.take_word("HIERARCHY") {
        return Err(not_a_hierarchy(source));
    }
    let mut reader =
        Reader { source, warnings, skeleton: Skeleton::new(), open: Vec::new(), places: Vec::new() };
    reader.joints()?;
    reader.warn_of_repeated_name();
    Ok(reader.skeleton)
}

struct Reader<'a, 'r> {
    source: &'a mut Source<'r>,
    warnings: &'a mut Vec<Warning>,
    skeleton: Skeleton,
    /// The joints whose `}` has not come yet, the innermost last. A list, because a file can nest deeper than
    /// calls can.
    open: Vec<JointId>,
    /// Where each joint's name stands.
    places: Vec<Place>,
}

impl Reader<'_, '_> {
    fn joints(&mut self) -> Result<(), Error> {
        loop {
            match self.open.last().copied() {
                None if self.source.take_word("ROOT") => self.joint(None)?,
                None if !self.skeleton.is_empty() && self.source.take_word("MOTION") => return Ok(()),
                None => return Err(self.not_a_root()),
                Some(parent) if self.source.take_word("JOINT") => self.joint(Some(parent))?,
                Some(parent) if self.source.is_word("End") => self.end_site(parent)?,
                Some(_) if self.source.take_word("}") => {
                    self.open.pop();
                }
                Some(parent) => return Err(self.not_a_part_of(parent)),
            }
        }
    }

    /// Reads a joint from its name up to its channels. What else belongs to it, up to its `}`, comes later.
    fn joint(&mut self, parent: Option<JointId>) -> Result<(), Error> {
        let (mut name, place) = self.name()?;
        if name.is_empty() {
            let keyword = if parent.is_some() { "JOINT" } else { "ROOT" };
            return Err(Error::here(self.source, ErrorKind::NoName { keyword }));
        }
        if parent.is_none() && !self.skeleton.is_empty() {
            warn(self.warnings, place, WarningKind::SeveralRoots);
        }
        self.opening_brace(&mut name)?;
        let (mut offset, mut channels) = (None, None);
        loop {
            if offset.is_none() && self.source.take_word("OFFSET") {
                offset = Some(self.vector()?);
            } else if channels.is_none() && self.source.take_word("CHANNELS") {
                channels = Some(self.channels()?);
            } else {
                break;
            }
        }
        let Some(offset) = offset else {
            return Err(Error::unexpected(self.source, "OFFSET and three numbers"));
        };
        let channels = channels.unwrap_or_else(|| {
            warn(self.warnings, place, WarningKind::NoChannels { joint: printable_start(name.as_bytes()) });
            Vec::new()
        });
        let id = self.skeleton.add_joint(parent, name, offset, channels).map_err(|e| self.refused(e))?;
        self.open.push(id);
        self.places.push(place);
        Ok(())
    }

    /// Reads an End Site, the `}` included.
    fn end_site(&mut self, parent: JointId) -> Result<(), Error> {
        if !is_end_site(self.source.peek_line()) {
            self.source.take_word("End");
            return Err(Error::unexpected(self.source, "`Site` behind `End`"));
        }
        let (mut name, place) = self.name()?;
        self.opening_brace(&mut name)?;
        words::take(self.source, "OFFSET", "OFFSET and three numbers")?;
        let offset = self.vector()?;
        words::take(self.source, "}", "`}`: an End Site has an OFFSET and nothing else")?;
        self.skeleton.add_end_site(parent, name, offset).map_err(|e| self.refused(e))?;
        self.places.push(place);
        Ok(())
    }

    /// Takes the rest of the line, or what stands in front of a lone `{` in it. Gives the name and its place.
    fn name(&mut self) -> Result<(String, Place), Error> {
        let line = self.source.peek_line();
        let (end, is_cut) = (lone_brace(line).unwrap_or(line.len()), line.len() > LONGEST_WORD);
        let behind = line[..end].iter().rposition(|&byte| !is_blank(byte)).map_or(0, |last| last + 1);
        if behind > LONGEST_WORD {
            return Err(self.long_name());
        }
        let name = &line[..end];
        let (name, is_utf8) = match std::str::from_utf8(&name[..behind]) {
            Ok(name) => (name.to_owned(), true),
            Err(_) => (String::from_utf8_lossy(&name[..behind]).into_owned(), false),
        };
        let place = self.source.place();
        if !is_utf8 {
            warn(self.warnings, place, WarningKind::NameEncoding { name: printable_start(name.as_bytes()) });
        }
        self.source.take(behind);
        // Blanks behind a name are no part of it, however many.
        let rest = if is_cut { self.source.peek_line() } else { &[] };
        if !rest.is_empty() && lone_brace(rest) != Some(0) {
            return Err(self.long_name());
        }
        Ok((name, place))
    }

    fn long_name(&mut self) -> Error {
        Error::here(self.source, ErrorKind::LongName { longest: LONGEST_WORD })
    }

    /// Takes the `{` behind a name; or off the name, if it ends in one (`Hips{`) and no other comes.
    fn opening_brace(&mut self, name: &mut String) -> Result<(), Error> {
        let goes_on = ["OFFSET", "CHANNELS"].into_iter().any(|word| self.source.is_word(word));
        if goes_on && name.ends_with('{') && !name.ends_with("{{") {
            name.pop();
            return Ok(());
        }
        words::take(self.source, "{", "`{`, set off by a blank")
    }

    fn vector(&mut self) -> Result<Vec3, Error> {
        let mut number = || words::number(self.source);
        Ok(Vec3::new(number()?, number()?, number()?))
    }

    /// Reads the number behind `CHANNELS` and as many words.
    fn channels(&mut self) -> Result<Vec<Channel>, Error> {
        self.source.peek();
        let snippet = self.source.snippet();
        let (declared, place) = words::count(self.source, "the number of channels, a whole number")?;
        let mut channels = Vec::new();
        loop {
            let word = self.source.peek();
            let length = word.len();
            match std::str::from_utf8(word).ok().and_then(Channel::from_word) {
                Some(channel) if channels.contains(&channel) => {
                    return Err(Error::here(self.source, ErrorKind::RepeatedChannel { channel }));
                }
                Some(channel) => channels.push(channel),
                None => break,
            }
            self.source.take(length);
        }
        let listed = channels.len() as u64;
        match listed == declared {
            true => Ok(channels),
            false => Err(self.miscounted_channels(place, snippet, declared, listed)),
        }
    }

    /// The list of channels is over, but at a word that may be meant as a channel, or not after as many as
    /// declared.
    fn miscounted_channels(&mut self, place: Place, snippet: Snippet, declared: u64, listed: u64) -> Error {
        const OTHER_WORDS: [&str; 8] = ["{", "}", "ROOT", "JOINT", "End", "OFFSET", "CHANNELS", "MOTION"];
        let is_other = OTHER_WORDS.into_iter().any(|word| self.source.is_word(word));
        match self.source.peek() {
            _ if is_other || listed > declared => {
                let kind = ErrorKind::ChannelCount { declared, listed };
                Error::before(place, Some(snippet), self.source, kind)
            }
            word if word.is_empty() || is_conflict_mark(word) => Error::unexpected(self.source, "a channel"),
            word => {
                let found = printable_start(word);
                Error::here(self.source, ErrorKind::UnknownChannel { found })
            }
        }
    }

    /// Skeletons do not take everything, but what is read here should be all right.
    fn refused(&mut self, error: SkeletonError) -> Error {
        Error::here(self.source, ErrorKind::Skeleton(error))
    }

    fn not_a_root(&mut self) -> Error {
        if self.source.is_word("}") && !self.skeleton.is_empty() {
            return Error::here(self.source, ErrorKind::NothingToClose);
        }
        Error::unexpected(self.source, if self.skeleton.is_empty() { "ROOT" } else { "ROOT or MOTION" })
    }

    fn not_a_part_of(&mut self, parent: JointId) -> Error {
        let closes_all = ["MOTION", "ROOT", ""].into_iter().any(|word| self.source.is_word(word));
        if !closes_all {
            return Error::unexpected(self.source, "JOINT, End Site or `}`");
        }
        let joint = self.skeleton.label(parent);
        let line = self.places.get(parent.0).map_or(0, |place| place.line);
        let joint = printable_start(joint.as_bytes());
        let found = match self.source.peek() {
            [] => String::from("the end of the file"),
            word => format!("`{}`", printable_start(word)),
        };
        Error::here(self.source, ErrorKind::NotClosed { found, joint, line })
    }

    /// Warns if two joints share a name: at the first that repeats one.
    fn warn_of_repeated_name(&mut self) {
        let joints = self.skeleton.joints();
        let mut by_name: Vec<usize> = (0..joints.len()).filter(|&id| !joints[id].is_end_site).collect();
        // A stable sort: joints of one name stay in the order of the file.
        by_name.sort_by_key(|&id| &joints[id].name);
        let same_name = |pair: &&[usize]| joints[pair[0]].name == joints[pair[1]].name;
        let Some(&[first, second]) = by_name
            .windows(2)
            .filter(same_name)
            .min_by_key(|pair| pair[1])
            .and_then(|pair| pair.first_chunk())
        else {
            return;
        };
        let name = printable_start(joints[second].name.as_bytes());
        let kind = WarningKind::RepeatedName { name, first_line: self.places[first].line };
        warn(self.warnings, self.places[second], kind);
    }
}

/// Where in `line` a `{` stands that is no part of a longer word.
pub(super) fn lone_brace(line: &[u8]) -> Option<usize> {
    let is_edge = |at: usize| line.get(at).is_none_or(|&byte| is_blank(byte));
    (0..line.len()).find(|&at| line[at] == b'{' && (at == 0 || is_edge(at - 1)) && is_edge(at + 1))
}

/// Whether a line that begins with the word `End` goes on with `Site`.
pub(super) fn is_end_site(line: &[u8]) -> bool {
    let mut words = line.split(|&byte| is_blank(byte)).filter(|word| !word.is_empty());
    let is = |word: Option<&[u8]>, wanted: &[u8]| word.is_some_and(|word| word.eq_ignore_ascii_case(wanted));
    is(words.next(), b"End") && is(words.next().and_then(|word| word.get(..4)), b"Site")
}

/// The text does not begin as it should. What else may it be?
fn not_a_hierarchy(source: &mut Source) -> Error {
    if source.is_word("ROOT") || source.is_word("MOTION") {
        let found = printable_start(source.peek());
        return Error::here(source, ErrorKind::NoHierarchy { found });
    }
    let word = source.peek();
    let found = printable_start(word);
    let guess = match word {
        [] => return Error::here(source, ErrorKind::Empty),
        word if is_conflict_mark(word) => return Error::unexpected(source, "HIERARCHY"),
        [b'{' | b'[', ..] => " (JSON?)",
        [b'<', ..] => " (XML?)",
        [b'#' | b':', ..] => " (Acclaim?)",
        _ => match not_a_text(word) {
            Some(guess) => {
                let (place, kind) = (source.place(), ErrorKind::NotBvh { found, guess });
                return Error::before(place, None, source, kind);
            }
            None => "",
        },
    };
    Error::here(source, ErrorKind::NotBvh { found, guess })
}
