//! Real processes that behave as badly as a shell can.

use super::*;

/// Far less than a test may take, far more than any of these needs.
const SOON: Duration = Duration::from_secs(20);

const SECOND: Duration = Duration::from_secs(1);

fn shell(script: &str) -> Command {
    let mut command = Command::new("/bin/sh");
    command.args(["-c", script]);
    command
}

#[track_caller]
fn asked(script: &str, job: &Job, wall: Duration) -> Reply {
    let start = Instant::now();
    let reply = ask(shell(script), job, wall, &mut |_| {}).unwrap();
    let took = start.elapsed();
    assert!(took < wall + SOON, "it took {took:?}");
    assert_eq!(reply.answers.len(), job.len());
    reply
}

#[track_caller]
fn ends(script: &str, ending: Ending) {
    assert_eq!(asked(script, &hits(1), SOON).ending, ending);
}

/// A script that begins to read its job before it does anything else, so that we are not still
/// writing when it ends.
fn after_the_job(script: &str) -> String {
    format!("head -c 4 >/dev/null; {script}")
}

#[test]
fn submission_that_exits_at_once_is_reported() {
    for code in [0, 3] {
        ends(&format!("exit {code}"), Ending::Died(Death::Exit(code)));
    }
}

#[test]
fn signals_and_exit_codes_are_told_apart() {
    ends("kill -9 $$", Ending::Died(Death::Signal(9)));
    ends("exit 139", Ending::Died(Death::Exit(139)));
}

#[test]
fn printed_words_are_no_reason() {
    let says = "echo main has overflowed its stack;";
    ends(&format!("{says} exit 1"), Ending::Died(Death::Exit(1)));
    let aborts = format!("{says} kill -ABRT $$");
    ends(&aborts, Ending::Died(Death::Signal(6)));
}

#[test]
fn sleeping_submission_is_ended_at_the_time_limit() {
    let reply = asked("echo $$; exec sleep 600", &hits(1), SECOND);
    assert_eq!(reply.ending, Ending::TimedOut(SECOND));
    let process = reply.printed.trim();
    assert!(process.parse::<u32>().is_ok(), "{process:?}");
    let alive = shell(&format!("kill -0 {process} 2>/dev/null")).status();
    assert!(!alive.unwrap().success(), "the process lives on");
}

#[test]
fn submission_that_never_reads_its_job_is_ended_at_the_time_limit() {
    let job = hits(200_000);
    let reply = asked("exec sleep 600", &job, SECOND);
    assert_eq!(reply.ending, Ending::TimedOut(SECOND));
}

#[test]
fn sending_bytes_slowly_gains_no_time() {
    // A message of 4095 bytes, one every tenth of a second.
    let drip = after_the_job(
        "printf '\\377\\017\\000\\000' >&0; while :; do printf x >&0; sleep 0.1; done",
    );
    let reply = asked(&drip, &hits(1), SECOND);
    assert_eq!(reply.ending, Ending::TimedOut(SECOND));
}

#[test]
fn a_submission_starts_once() {
    let twice =
        after_the_job("for k in 1 2; do printf '\\1\\0\\0\\0\\5' >&0; done; exec sleep 600");
    let Ending::Garbled(why) = asked(&twice, &hits(1), SOON).ending else {
        panic!("the second message is refused")
    };
    assert_eq!(why, "it said twice that it has started");
}

#[test]
fn flood_of_output_is_read_and_discarded() {
    let reply = asked("exec yes", &hits(1), SECOND);
    assert_eq!(reply.ending, Ending::TimedOut(SECOND));
    assert!(reply.printed.len() <= MOST_PRINTED);

    let reply = asked("yes | head -c 1000000; exit 1", &hits(1), SOON);
    assert_eq!(reply.printed.len(), MOST_PRINTED);
    assert!(matches!(reply.ending, Ending::Died(_)));
}

#[test]
fn output_and_errors_are_both_kept() {
    let reply = asked("echo one; echo two >&2", &hits(1), SOON);
    assert_eq!(reply.printed, "one\ntwo\n");
}

#[test]
fn output_need_not_be_text() {
    let reply = asked("printf 'a\\377b'", &hits(1), SOON);
    assert_eq!(reply.printed, "a\u{fffd}b");
}

#[test]
fn process_left_behind_is_not_waited_for() {
    let start = Instant::now();
    let reply = asked("sleep 30 & exit 0", &hits(1), SOON);
    assert!(matches!(reply.ending, Ending::Died(_)));
    assert!(start.elapsed() < Duration::from_secs(15));
}

#[test]
fn garbage_in_place_of_answers_is_reported() {
    ends(
        &after_the_job("printf garbage >&0"),
        Ending::Garbled("a message of 1651663207 bytes is too long".into()),
    );
    ends(
        &after_the_job("printf '\\003\\000\\000\\000abc' >&0"),
        Ending::Garbled("a message could not be read".into()),
    );
    // Two messages of answers from question 10 on: one without an answer, one with a miss.
    ends(
        &after_the_job("printf '\\003\\000\\000\\000\\000\\012\\000' >&0"),
        Ending::Garbled("it sent a message without an answer".into()),
    );
    ends(
        &after_the_job("printf '\\006\\000\\000\\000\\000\\012\\001\\000\\000\\000' >&0"),
        Ending::Garbled("it answered a question that was not asked".into()),
    );
}

#[test]
fn submission_that_breaks_off_inside_a_message_is_reported() {
    let reply = asked(
        &after_the_job("printf '\\012\\000\\000\\000ab' >&0"),
        &hits(1),
        SOON,
    );
    assert!(
        matches!(reply.ending, Ending::Died(_)),
        "{:?}",
        reply.ending
    );
}

#[test]
fn one_answer_is_enough_for_one_question() {
    // A message of answers that begins at question 0 and holds one answer, a miss.
    let miss = after_the_job("printf '\\006\\000\\000\\000\\000\\000\\001\\000\\000\\000' >&0");
    let reply = asked(&miss, &hits(1), SOON);
    assert_eq!(reply.ending, Ending::Complete);
    assert_eq!(reply.answers, [Some(Answer::Hit(None))]);
}

#[test]
fn job_without_questions_needs_no_answer() {
    assert_eq!(asked("exit 3", &hits(0), SOON).ending, Ending::Complete);
}

#[test]
fn submission_that_cannot_be_started_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let absent: &Path = &folder.path().join("absent");
    assert!(ask(Command::new(absent), &hits(1), SOON, &mut |_| {}).is_err());
}

#[test]
fn cancelled_submission_is_ended_long_before_its_time_limit() {
    let limit = Limit::from(10 * SOON);
    let stop = limit.stop.clone();
    let start = Instant::now();
    let reply = std::thread::scope(|scope| {
        let asking = scope.spawn(|| ask(shell("sleep 200"), &hits(1), limit, &mut |_| {}));
        std::thread::sleep(SECOND / 2);
        stop.raise();
        asking.join().expect("it does not panic")
    });
    let error = reply.expect_err("there is no answer");
    assert!(error.to_string().contains("no longer needed"), "{error}");
    assert!(start.elapsed() < SOON, "it took {:?}", start.elapsed());
}

#[test]
fn limits_do_not_count_waiting_for_a_processor_unless_it_takes_twenty_times_as_long() {
    let answers = |clock: fn() -> Clock, wall, silence| {
        // As above, after a second.
        let miss = "sleep 1; printf '\\006\\000\\000\\000\\000\\000\\001\\000\\000\\000' >&0";
        let limit = Limit {
            silence,
            ..Limit::from(wall)
        };
        let command = shell(&after_the_job(miss));
        let reply = ask_watched(command, &hits(1), limit, &mut |_| {}, &mut |_| clock());
        reply.unwrap().ending
    };
    let waits = || -> Clock { Box::new(|| Duration::ZERO) };
    let (short, shortest) = (SECOND / 5, SECOND / 40);
    for (wall, silence) in [(SOON, short), (short, SOON)] {
        assert_eq!(answers(wall_clock, wall, silence), Ending::TimedOut(short));
        assert_eq!(answers(waits, wall, silence), Ending::Complete);
    }
    assert_eq!(answers(waits, shortest, SOON), Ending::TimedOut(shortest));
}
