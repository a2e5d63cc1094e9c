// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMAND_LINE_WORDS_H
#define COMMAND_LINE_WORDS_H

#include <cstddef>
#include <string>
#include <vector>

/* Commands as a shell has them. */
namespace command_line {

// A word as one can type it, in a shell.
inline std::string quoted(const std::string& word) {
  const bool is_plain =
      !word.empty() && word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                                              "_@%+=:,./-") == std::string::npos;
  if (is_plain)
    return word;
  std::string text = "'";
  for (char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

inline std::string text_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}

// The command that was typed, under the program's plain name.
inline std::string text_of(const std::string& program, int argc, char* argv[]) {
  std::vector<std::string> words(argv + 1, argv + argc);
  words.insert(words.begin(), program);
  return text_of(words);
}

// Without the white space around it.
inline std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

/* The words of a text: quotes and backslashes are those of a shell, nothing else has a meaning. False if a quote is not
 * closed, or nothing follows a backslash. */
inline bool split_words(const std::string& text, std::vector<std::string>& words) {
  char quote = 0; // in which the text is
  bool is_word = false;
  std::string word;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool ends_word = quote == 0 && (c == ' ' || c == '\t' || c == '\n' || c == '\r');
    if (ends_word && is_word)
      words.push_back(word);
    if (ends_word) {
      word.clear();
      is_word = false;
      continue;
    }
    is_word = true;
    if (c == '\\' && quote != '\'') {
      if (++i == text.size())
        return false;
      const bool stays = quote == '"' && text[i] != '"' && text[i] != '\\';
      word += (stays ? "\\" : "") + std::string(1, text[i]);
    } else if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else if (c == quote)
      quote = 0;
    else
      word += c;
  }
  if (is_word)
    words.push_back(word);
  return quote == 0;
}

} // namespace command_line

#endif // COMMAND_LINE_WORDS_H
