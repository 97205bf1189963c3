// SPDX-License-Identifier: LGPL-2.1-or-later
// Starts softgrain many times. Most of the time of a short call is that of linking with the libraries; here
// that is done once, and each call is a process of its own that is forked from this one. Line by line from
// the standard input: the words of a call, parted by the character 31. Its output goes to
// two files, which are the arguments; its exit code, or minus the signal that ended it, comes back as a line.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

/// That of source/app/main.cc.
int softgrain_main(int argc, char **argv);

namespace
{
void lead(const int stream, const char *const file, const int flags)
{
  const int opened = open(file, flags, 0644);
  if (opened < 0 || dup2(opened, stream) < 0)
    _exit(127);
  close(opened);
}

[[noreturn]] void be_softgrain(std::vector<std::string> &words, char **const files)
{
  lead(STDIN_FILENO, "/dev/null", O_RDONLY);
  lead(STDOUT_FILENO, files[0], O_WRONLY | O_CREAT | O_TRUNC);
  lead(STDERR_FILENO, files[1], O_WRONLY | O_CREAT | O_TRUNC);
  std::vector<char *> arguments;
  for (std::string &word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::exit(softgrain_main(static_cast<int>(words.size()), arguments.data()));
}
} // namespace

int main(int argc, char **argv)
{
  if (argc != 3)
    return 2;
  for (std::string line; std::getline(std::cin, line);)
  {
    std::vector<std::string> words = {"softgrain"};
    std::istringstream parts(line);
    for (std::string word; std::getline(parts, word, '\x1f');)
      words.push_back(word);
    const pid_t child = fork();
    if (child == 0)
      be_softgrain(words, argv + 1);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
      return 1;
    std::cout << (WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status)) << std::endl;
  }
}
