// Piping Component Files written from the format: a spool with every kind of record, and oddities.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/piping/pcf_samples.h"

#include <algorithm>
#include <cassert>
#include <cctype>

namespace spool::test {

std::string spool_pcf() {
  return R"(ISOGEN-FILES    ISOGEN.FLS
UNITS-BORE      INCH
UNITS-CO-ORDS   MM
UNITS-WEIGHT    KGS
UNITS-BOLT-DIA  MM
UNITS-BOLT-LENGTH MM
PIPELINE-REFERENCE 10-3-PL-3259-002
    PIPING-SPEC       CS150
    NOMINAL-CLASS     150
    REVISION          2
    SPOOL-PREFIX      10-3-PL-3259-SP
    START-CO-ORDS     1000.0 2000.0 500.0
FLANGE
    END-POINT         1000.0 2000.0 500.0 3 FL
    END-POINT         1069.8 2000.0 500.0 3 BW
    SKEY              FLWN
    ITEM-CODE         F3
    UCI               0001
    FABRICATION-ITEM
    SPOOL-IDENTIFIER  SP1
PIPE
    END-POINT         1069.8 2000.0 500.0 3
    END-POINT         1386.0 2000.0 500.0 3
    ITEM-CODE         P3
    HEAT-NUMBER       H-77
    FABRICATION-ITEM
    SPOOL-IDENTIFIER  SP1
WELD
    END-POINT         1069.8 2000.0 500.0 3
    END-POINT         1069.8 2000.0 500.0 3
    SKEY              WW
    WELD-ATTRIBUTE1   W-101
    SPOOL-IDENTIFIER  SP1
ELBOW
    END-POINT         1386.0 2000.0 500.0 3 BW
    END-POINT         1500.0 2114.0 500.0 3 BW
    CENTRE-POINT      1500.0 2000.0 500.0
    SKEY              ELBW
    ANGLE             9000
    ITEM-CODE         E3
    SPOOL-IDENTIFIER  SP1
PIPE
    END-POINT         1500.0 2114.0 500.0 3
    END-POINT         1500.0 2414.0 500.0 3
    ITEM-CODE         P3
    SPOOL-IDENTIFIER  SP1
TEE
    END-POINT         1500.0 2414.0 500.0 3 BW
    END-POINT         1500.0 2586.0 500.0 3 BW
    CENTRE-POINT      1500.0 2500.0 500.0
    BRANCH1-POINT     1500.0 2500.0 576.0 2 BW
    SKEY              TEBW
    ITEM-CODE         T32
    SPOOL-IDENTIFIER  SP1
PIPE
    END-POINT         1500.0 2500.0 576.0 2
    END-POINT         1500.0 2500.0 776.0 2
    ITEM-CODE         P2
    SPOOL-IDENTIFIER  SP1
CAP
    END-POINT         1500.0 2500.0 776.0 2 BW
    SKEY              KABW
    ITEM-CODE         C2
    SPOOL-IDENTIFIER  SP1
REDUCER-ECCENTRIC
    END-POINT         1500.0 2586.0 500.0 3 BW
    END-POINT         1500.0 2675.0 485.7 2 BW
    FLAT-DIRECTION    DOWN
    SKEY              REBW
    ITEM-CODE         R32
    SPOOL-IDENTIFIER  SP1
WELD
    CO-ORDS           1500.0 2675.0 485.7
    SKEY              WS
    NAME              FW-7
PIPE
    END-POINT         1500.0 2675.0 485.7 2
    END-POINT         1500.0 2875.0 485.7 2
    ITEM-CODE         P2
    SPOOL-IDENTIFIER  SP2
OLET
    CENTRE-POINT      1500.0 2775.0 485.7
    BRANCH1-POINT     1500.0 2775.0 540.0 0.75 SW
    SKEY              SKSW
    ITEM-CODE         O
    SPOOL-IDENTIFIER  SP2
ELBOW
    END-POINT         1500.0 2875.0 485.7 2 BW
    END-POINT         1500.0 2934.7487 510.4487 2 BW
    CENTRE-POINT      1500.0 2910.0 485.7
    SKEY              ELBW
    ANGLE             45.0
    ITEM-CODE         E245
    SPOOL-IDENTIFIER  SP2
FLANGE
    END-POINT         1500.0 2934.7487 510.4487 2 BW
    END-POINT         1500.0 2979.6500 555.3500 2 FL
    SKEY              FOWN
    ITEM-CODE         F2
    TAP-CONNECTION
        CO-ORDS       1553.9 2972.9 548.6 0.5
    SPOOL-IDENTIFIER  SP2
GASKET
    END-POINT         1500.0 2979.6500 555.3500 2 FL
    END-POINT         1500.0 2981.7713 557.4713 2 FL
    ITEM-CODE         G2
    ERECTION-ITEM
BOLT
    CO-ORDS           1500.0 2979.6500 555.3500
    BOLT-DIA          16
    BOLT-LENGTH       85
    BOLT-QUANTITY     4
    ITEM-CODE         B16
VALVE
    END-POINT         1500.0 2981.7713 557.4713 2 FL
    END-POINT         1500.0 3107.6363 683.3363 2 FL
    SKEY              VTFL
    SPINDLE-DIRECTION UP
    TAG               HV-101
    ERECTION-ITEM
SUPPORT
    CO-ORDS           1500.0 2250.0 455.5
    SKEY              SKID
    NAME              PS-12
MESSAGE
    CO-ORDS           0 0 0
    TEXT              keep clear
END-CONNECTION-EQUIPMENT
    CO-ORDS           1000.0 2000.0 500.0
    CONNECTION-REFERENCE V-201/N2
MATERIALS
ITEM-CODE     F3
    DESCRIPTION FLANGE WN RF CL150
    DESCRIPTION SCH STD ASTM A105
ITEM-CODE     P3
    DESCRIPTION PIPE SMLS SCH 40 A106-B
ITEM-CODE     P2
    DESCRIPTION PIPE SMLS SCH 80 A106-B
ITEM-CODE     E3
    DESCRIPTION ELBOW 90 LR BW SCH40
ITEM-CODE     E245
    DESCRIPTION ELBOW 45 LR BW S-80
ITEM-CODE     T32
    DESCRIPTION TEE RED BW SCH 40 X SCH 80
ITEM-CODE     C2
    DESCRIPTION CAP BW XS
ITEM-CODE     R32
    DESCRIPTION RED ECC BW SCH 40
ITEM-CODE     O
    DESCRIPTION SOCKOLET 3000# SCH 80
ITEM-CODE     F2
    DESCRIPTION ORIFICE FLANGE WN RF 150# SCH 80
ITEM-CODE     G2
    DESCRIPTION GASKET SPW 4.5MM CL150
ITEM-CODE     B16
    DESCRIPTION STUDBOLT M16 B7
)";
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  std::size_t at = text.find(from);
  assert(at != std::string::npos && "the text to be replaced is not there");
  for (; at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string unindented(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool leads = (text[i] == ' ') && (out.empty() || out.back() == '\n');
    if (!leads) out += text[i];
  }
  return out;
}

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

int line_of(const std::string& text, std::string_view what) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) return 0;
  return 1 + static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string pcf(const std::string& components, const std::string& header) {
  return header + "PIPELINE-REFERENCE L-1\n" + components;
}

}  // namespace spool::test
