#pragma once

#include <string>
#include <string_view>

namespace xabsl::documentation {

/// Text as valid UTF-8 without control characters. Bytes that are no UTF-8 are taken for Latin-1,
/// in which older files are written.
std::string utf8(std::string_view text);

/// Text for HTML, also within quotes. Valid UTF-8, as above.
std::string escaped(std::string_view text);

/// Text for a string of JSON or JavaScript, with its quotes.
std::string quotedScript(std::string_view text);

/// A name as a part of the name of a file that any file system takes, or of a fragment of an
/// address. Different names stay different.
std::string encoded(std::string_view name);

/// The text of a documentation comment without the stars that begin its lines.
std::string plainDoc(std::string_view doc);

/// The same as paragraphs of HTML.
std::string paragraphs(std::string_view doc);

/// Its first sentence, as plain text.
std::string firstSentence(std::string_view doc);

}  // namespace xabsl::documentation
