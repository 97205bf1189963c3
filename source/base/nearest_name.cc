// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/nearest_name.h>

#include <algorithm>
#include <cctype>

namespace softgrain
{
namespace
{
std::string lower(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}
} // namespace

unsigned int edit_distance(const std::string &first, const std::string &second)
{
  const std::string a = lower(first), b = lower(second);
  std::vector<std::vector<unsigned int>> d(a.size() + 1, std::vector<unsigned int>(b.size() + 1));
  for (unsigned int i = 0; i <= a.size(); ++i)
    d[i][0] = i;
  for (unsigned int j = 0; j <= b.size(); ++j)
    d[0][j] = j;
  for (unsigned int i = 1; i <= a.size(); ++i)
    for (unsigned int j = 1; j <= b.size(); ++j)
    {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string nearest_name(const std::string &word, const std::vector<std::string> &names)
{
  std::string best;
  unsigned int best_distance = std::max<unsigned int>(2, word.size() / 3) + 1;
  for (const std::string &name : names)
  {
    const unsigned int distance = edit_distance(word, name);
    if (distance < best_distance)
    {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

std::string join(const std::vector<std::string> &words, const std::string &none)
{
  if (words.empty())
    return none;
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i)
    text += ", " + words[i];
  return text;
}
} // namespace softgrain
