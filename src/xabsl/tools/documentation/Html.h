#pragma once

#include <string>
#include <string_view>

namespace xabsl::documentation {

/// Text as valid UTF-8 without control characters. Bytes that are not UTF-8 are read as Latin-1,
/// which older files use.
std::string utf8(std::string_view text);

/// Text escaped for HTML, also within quotes, as valid UTF-8 like `utf8`.
std::string escaped(std::string_view text);

/// Text as a string of JSON or JavaScript, with its quotes.
std::string quotedScript(std::string_view text);

/// A name encoded for a file name that any file system accepts, or for a fragment of an address.
/// Different names stay different.
std::string encoded(std::string_view name);

/// The text of a documentation comment without the stars that begin its lines.
std::string plainDoc(std::string_view doc);

/// The text of a documentation comment as paragraphs of HTML.
std::string paragraphs(std::string_view doc);

/// The first sentence of a documentation comment, as plain text.
std::string firstSentence(std::string_view doc);

}  // namespace xabsl::documentation
