//! Streams that no program of ours would send.

use super::*;
use crate::job;

#[test]
fn no_stream_harms_the_reader_or_completes_a_reply_without_answers() {
    bolero::check!().for_each(|bytes| {
        for job in [hits(6), rays(6)] {
            let mut reply = Reply::before(&job);
            let mut input = bytes;
            while let Ok(Some(message)) = job::receive(&mut input, MOST_MESSAGE) {
                if reply.take(&job, message) != Ok(Next::Receive) {
                    break;
                }
            }
            let missing = reply
                .answers
                .iter()
                .filter(|answer| answer.is_none())
                .count();
            assert_eq!(reply.missing, missing);
            assert_eq!(reply.answers.len(), 6);
        }
    });
}
