// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/console.hpp"
#include "testbench/arguments.hpp"

namespace trammel::an693 {

std::vector<testbench::Verb> verbs() {
  testbench::Verb verb;
  verb.name = "lm628";
  verb.help = "the commands of an LM628 with its motor: a script, or a conversation";
  verb.argument = "script";
  verb.argument_help =
      "built-in name, file, or - for standard input; none on a terminal: a conversation, in which "
      "`help` names the commands";
  verb.out_help = "write what `trammel run` writes into this folder, and script.lm628";
  verb.simulates = true;
  verb.trigger_help = "at TIME";  // a script runs once, so that no event is known before
  verb.is_conversation = is_conversation;
  verb.perform = [](const testbench::Arguments& arguments, std::atomic<bool>& stop) {
    return lm628_shell(arguments, stop,
                       is_conversation(arguments) ? terminal_lines(stop) : ReadLine());
  };
  return {verb};
}

}  // namespace trammel::an693
