use super::*;
use crate::ray::{Hit, Intersection};
use crate::testing::Random;
use glam::DVec3;

const MOST: usize = 1000;

fn message() -> Message {
    let intersection = Intersection {
        t: 1.5,
        normal: DVec3::Y,
    };
    Message::Answers {
        first: 300,
        answers: vec![
            Answer::Hit(None).into(),
            Answer::Hit(Some(Hit {
                object: 7,
                intersection,
            }))
            .into(),
        ],
    }
}

fn sent(message: &Message) -> Vec<u8> {
    let mut bytes = Vec::new();
    send(message, &mut bytes).unwrap();
    bytes
}

fn receive_from(bytes: &[u8]) -> io::Result<Option<Message>> {
    receive(&mut &bytes[..], MOST)
}

#[track_caller]
fn refused(bytes: &[u8], why: &str) {
    let error = receive_from(bytes).expect_err("this message should be refused");
    assert!(error.to_string().contains(why), "{error}");
}

#[test]
fn what_is_sent_is_received() {
    assert_eq!(receive_from(&sent(&message())).unwrap(), Some(message()));
}

#[test]
fn messages_come_one_by_one_until_the_end() {
    let two = [sent(&message()), sent(&message())].concat();
    let mut input = two.as_slice();
    for _ in 0..2 {
        let received: Option<Message> = receive(&mut input, MOST).unwrap();
        assert_eq!(received, Some(message()));
    }
    assert_eq!(receive::<Message>(&mut input, MOST).unwrap(), None);
}

#[test]
fn an_interrupted_message_goes_on() {
    /// Says at every other call that it was interrupted.
    struct Interrupted<'a>(&'a [u8], bool);

    impl Read for Interrupted<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.1 = !self.1;
            match self.1 {
                true => Err(io::ErrorKind::Interrupted.into()),
                false => self.0.read(buffer),
            }
        }
    }

    let bytes = sent(&message());
    let received: Option<Message> = receive(&mut Interrupted(&bytes, false), MOST).unwrap();
    assert_eq!(received, Some(message()));
}

#[test]
fn a_message_as_long_as_allowed_is_received_and_a_longer_one_is_not() {
    let bytes = sent(&message());
    let length = bytes.len() - 4;
    assert!(receive::<Message>(&mut bytes.as_slice(), length).is_ok());
    let error = receive::<Message>(&mut bytes.as_slice(), length - 1).unwrap_err();
    assert!(error.to_string().contains("too long"), "{error}");
}

#[test]
fn message_with_too_large_a_length_is_refused_before_it_is_read() {
    refused(&u32::MAX.to_le_bytes(), "a message of 4294967295 bytes");
}

#[test]
fn message_that_breaks_off_is_refused() {
    let whole = sent(&message());
    for length in 1..whole.len() {
        let error = receive_from(&whole[..length]).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::UnexpectedEof, "{length}");
    }
}

#[test]
fn a_message_with_bytes_left_over_is_refused() {
    let mut bytes = sent(&message());
    bytes.push(0);
    bytes[0] += 1;
    refused(&bytes, "could not be read");
}

#[test]
fn a_message_that_is_too_short_inside_is_refused() {
    let mut bytes = sent(&message());
    bytes.pop();
    bytes[0] -= 1;
    refused(&bytes, "could not be read");
}

#[test]
fn a_message_of_unknown_kind_is_refused() {
    let mut bytes = sent(&message());
    bytes[4] = 9;
    refused(&bytes, "could not be read");
}

#[test]
fn a_list_that_claims_more_than_memory_holds_is_refused() {
    // An answers message: kind 0, first 0, then a length of nearly 2⁶⁴.
    let body = [
        0, 0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01,
    ];
    let bytes = [&(body.len() as u32).to_le_bytes(), body.as_slice()].concat();
    refused(&bytes, "could not be read");
}

#[test]
fn no_bytes_make_the_receiver_panic() {
    let mut random = Random::new(1);
    for _ in 0..5000 {
        let length = random.below(60);
        let body = random.bytes(length);
        let bytes = [&(length as u32).to_le_bytes(), body.as_slice()].concat();
        let _whatever_it_says = receive_from(&bytes);
    }
}

#[test]
fn a_job_is_as_long_as_its_answers() {
    assert!(Job::Ask(Questions::Intersect(Vec::new())).is_empty());
    let ray = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::Z,
    };
    assert_eq!(Job::Cast(ray, 0.0, Vec::new()).len(), 1);
}

#[test]
fn only_a_todo_is_unanswered() {
    let panic = |message: &str| Panic {
        message: message.into(),
        file: "src/sphere.rs".into(),
        line: 1,
        index: 0,
    };
    assert!(panic("not yet implemented: solve for t").is_unanswered());
    assert!(panic("not implemented").is_unanswered());
    assert!(!panic("index out of bounds: not yet implemented").is_unanswered());
    assert!(!panic("").is_unanswered());
}
