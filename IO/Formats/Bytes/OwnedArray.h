/// Store an array in memory from malloc, so that another owner, such as a VTK array, can adopt the
/// memory without a copy.

#ifndef ConformalOwnedArray_h
#define ConformalOwnedArray_h

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

namespace conformal
{
template <typename T>
class OwnedArray
{
  static_assert(std::is_trivially_copyable<T>::value, "values are moved as bytes");

public:
  T* data() { return this->Values.get(); }
  const T* data() const { return this->Values.get(); }
  std::size_t size() const { return this->Size; }
  T& operator[](std::size_t i) { return this->Values.get()[i]; }
  const T& operator[](std::size_t i) const { return this->Values.get()[i]; }

  /// Reserve memory for a total of `capacity` values.
  void reserve(std::size_t capacity)
  {
    if (capacity > this->Capacity)
    {
      this->reallocate(capacity);
    }
  }

  /// Change the number of values. Added values are not initialized.
  void resize(std::size_t size)
  {
    this->reserve(size);
    this->Size = size;
  }

  void push(T value)
  {
    if (this->Size == this->Capacity)
    {
      this->reallocate(std::max<std::size_t>(64, 2 * this->Capacity));
    }
    this->Values.get()[this->Size++] = value;
  }

  /// Append values that are not initialized.
  void extend(std::size_t count)
  {
    if (count > this->Capacity - this->Size)
    {
      this->reallocate(std::max(this->Size + count, 2 * this->Capacity));
    }
    this->Size += count;
  }

  /// Release reserved memory that is not used.
  void shrink()
  {
    if (this->Size < this->Capacity)
    {
      this->reallocate(this->Size);
    }
  }

  /// Transfer the memory to the caller, who must free it with std::free. Afterwards, the array is
  /// empty.
  T* release()
  {
    this->Size = this->Capacity = 0;
    return this->Values.release();
  }

private:
  void reallocate(std::size_t capacity)
  {
    if (capacity > std::numeric_limits<std::size_t>::max() / sizeof(T))
    {
      throw std::bad_alloc();
    }
    const std::size_t bytes = std::max<std::size_t>(1, capacity * sizeof(T));
    void* values = std::realloc(this->Values.get(), bytes);
    if (!values)
    {
      throw std::bad_alloc();
    }
    static_cast<void>(this->Values.release()); // realloc has freed it
    this->Values.reset(static_cast<T*>(values));
    this->Capacity = capacity;
  }

  struct Free
  {
    void operator()(void* values) const { std::free(values); }
  };
  std::unique_ptr<T, Free> Values;
  std::size_t Size = 0;
  std::size_t Capacity = 0;
};
}

#endif
