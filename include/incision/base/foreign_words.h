#pragma once

#include <string>
#include <vector>

namespace incision {

/// Words of other simulators' scenes that mean the same, and how that is said here.
struct ForeignWords {
  std::string beside;                 ///< keys, apart by spaces: the words are looked for where one of them is allowed
  std::string words;                  ///< apart by spaces, in lower case and without _ and -
  std::string how;                    ///< a sentence that the examples end
  std::vector<std::string> examples;  ///< each is a part of a scene, from its top
};

/// All that are known, by section in the order of a scene. No word stands twice beside one key.
const std::vector<ForeignWords>& foreignWords();

/// ": nodes are held by `…` or `…`" for a key that another simulator would have, however it is written (youngModulus,
/// young_modulus, Young-Modulus), in a section with these keys; nothing for a word that is not known.
std::string saidHere(const std::string& key, const std::vector<std::string>& allowed_keys);

}  // namespace incision
