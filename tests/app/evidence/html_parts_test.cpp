// Escaping and embedding, by the standards' own examples.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/html_parts.h"

#include <gtest/gtest.h>

namespace spool::evidence {
namespace {

TEST(Escaped, MakesMarkupHarmless) {
  EXPECT_EQ(escaped("<script>alert('1')</script> & \"x\""),
            "&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; &quot;x&quot;");
}

TEST(Escaped, KeepsUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(escaped("Rohr \xC3\xA4 \xE2\x8C\x80 \xF0\x9F\x94\xA7"),
            "Rohr \xC3\xA4 \xE2\x8C\x80 \xF0\x9F\x94\xA7");
  const std::string replacement = "\xEF\xBF\xBD";
  for (const char* bad :
       {"\xFF", "\xC0\xAF", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\x80"}) {
    const std::string html = escaped(bad);
    EXPECT_EQ(html.find(replacement), 0U) << html;
    EXPECT_EQ(html.size() % replacement.size(), 0U) << html;
  }
  EXPECT_EQ(escaped("a\n\tb"), "a  b");
}

TEST(Base64, EncodesTheVectorsOfRfc4648) {
  const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : cases) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\xFB\xFF\xFE", 3)), "+//+");
}

TEST(StatusShape, DiffersForEveryStatusAndNeedsNoColour) {
  const Verdict all[] = {Verdict::kOk, Verdict::kSuspicious, Verdict::kNotOk,
                         Verdict::kNotMeasured};
  for (const auto a : all)
    for (const auto b : all) {
      if (a == b) continue;
      const auto body = [](Verdict verdict) {
        const std::string svg = status_shape(verdict, 24);
        return svg.substr(svg.find('>') + 1);  // behind the colour
      };
      EXPECT_NE(body(a), body(b));
      EXPECT_NE(word(a), word(b));
    }
}

}  // namespace
}  // namespace spool::evidence
