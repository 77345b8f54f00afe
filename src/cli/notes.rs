//! What writers of files say, gathered so that one fact is told once.

use std::collections::BTreeMap;
use std::path::Path;

use meshwright::formats::groups::Note;

use super::voice::Voice;
use super::wording::grouped;

/// More notes than this are counted, not shown, unless asked for.
const MOST_NOTES: usize = 6;

/// What writers said, each with the files it is about.
#[derive(Default)]
pub struct Notes {
    texts: Vec<(String, bool)>,
    files: BTreeMap<String, Vec<String>>,
}

impl Notes {
    /// Takes what the writer of a file said.
    pub fn add(&mut self, output: &Path, notes: Vec<Note>) {
        for note in notes {
            let text = match &note {
                Note::SharedNumbers { .. } => format!("{note} (--unique-ids renumbers)"),
                note => note.to_string(),
            };
            let files = self.files.entry(text.clone()).or_default();
            if files.is_empty() {
                self.texts.push((text, note.is_warning()));
            }
            files.push(output.display().to_string());
        }
    }

    /// Warnings one by one; what only tells, in one line for the files that it is about.
    pub fn say(self, voice: &Voice) {
        let mut told: Vec<(String, Vec<String>)> = Vec::new();
        for (text, is_warning) in self.texts {
            let files = self.files[&text].join(", ");
            if is_warning {
                voice.warn(format!("{files}: {text}"));
                continue;
            }
            match told.last_mut().filter(|(same, _)| *same == files) {
                Some((_, texts)) => texts.push(text),
                None => told.push((files, vec![text])),
            }
        }
        for (files, mut texts) in told {
            if texts.len() > MOST_NOTES && !voice.verbose {
                let more = texts.len() - MOST_NOTES;
                texts.truncate(MOST_NOTES);
                texts.push(format!("and {} more (--verbose tells all)", grouped(more as u64)));
            }
            voice.note(format!("{files}: {}", texts.join("; ")));
        }
    }
}
