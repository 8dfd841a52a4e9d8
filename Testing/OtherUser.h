// Change the user from root to a user without access rights, while the object exists. Any other
// user is not changed.
#ifndef OtherUser_h
#define OtherUser_h

#include <fcntl.h>
#include <grp.h>
#include <unistd.h>

#include <string>
#include <vector>

class OtherUser
{
public:
  OtherUser()
    : IsRoot(geteuid() == 0)
  {
    constexpr unsigned nobody = 65534;
    if (this->IsRoot)
    {
      this->Groups.resize(static_cast<std::size_t>(getgroups(0, nullptr)));
      this->Groups.resize(static_cast<std::size_t>(
        getgroups(static_cast<int>(this->Groups.size()), this->Groups.data())));
      this->IsChanged = setgroups(0, nullptr) == 0 && setegid(nobody) == 0 && seteuid(nobody) == 0;
    }
  }
  ~OtherUser()
  {
    if (this->IsRoot &&
      (seteuid(0) != 0 || setegid(this->Group) != 0 ||
        setgroups(this->Groups.size(), this->Groups.data()) != 0))
    {
      _exit(1); // no test may continue as another user
    }
  }
  OtherUser(const OtherUser&) = delete;
  void operator=(const OtherUser&) = delete;

  /// Test whether the user is not root, and can enter a folder.
  bool isHere(const std::string& folder) const
  {
    return (!this->IsRoot || this->IsChanged) &&
      faccessat(AT_FDCWD, folder.c_str(), X_OK, AT_EACCESS) == 0;
  }

private:
  const bool IsRoot;
  const gid_t Group = getegid();
  std::vector<gid_t> Groups;
  bool IsChanged = false;
};

#endif
