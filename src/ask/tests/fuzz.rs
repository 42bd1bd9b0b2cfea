//! Streams that no program of ours would send.

use super::*;
use crate::job;
use crate::testing::fuzz::fuzz;

fn stream(messages: &[Message]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for message in messages {
        job::send(message, &mut bytes).unwrap();
    }
    bytes
}

#[test]
fn no_stream_harms_the_reader_or_completes_a_reply_without_answers() {
    let panic = Panic {
        message: "index out of bounds".into(),
        file: "src/plane.rs".into(),
        line: 12,
        index: 3,
    };
    let given = [hit(0), Answer::Hit(None), hit(2)];
    let seeds = [
        stream(&[answers(0, &given), answers(3, &given)]),
        stream(&[answers(3, &given), answers(0, &given)]),
        stream(&[answers(0, &given), Message::Panicked(panic)]),
        stream(&[answers(0, &[Answer::Ray(RAY); 6])]),
    ];
    fuzz("stream", &seeds, &[], |bytes| {
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
