#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/fields/kept.h"
#include "sph_solver/fields/law.h"

namespace tw {

/// What a table can do with a field whatever its elements are.
class AnyField {
public:
    enum class Element : std::uint8_t { float64, float32, int64, uint8, packed };

    AnyField() = default;
    AnyField(const char* name, Law law, Kept kept, With with, Element element)
        : name_(name), law_(law), kept_(kept), with_(with), element_(element) {}
    virtual ~AnyField() = default;

    const char* name() const { return name_; }
    bool in_images() const { return law_ != Law::unseen; }
    bool moves() const { return kept_ != Kept::sorted; }
    bool saved() const { return kept_ == Kept::saved; }
    With with() const { return with_; }
    Element element() const { return element_; }

    virtual std::size_t length() const = 0;
    virtual void set_length(std::size_t n) = 0;  ///< what is new has the element's default
    virtual void set_capacity(std::size_t n) = 0;
    virtual void let_go() = 0;                                      ///< of all elements and their memory
    virtual void take(const std::vector<std::int32_t>& order) = 0;  ///< element k becomes what element order[k] was
    virtual std::size_t bytes() const = 0;
    virtual std::size_t element_bytes() const = 0;
    virtual const void* raw() const = 0;
    virtual void* raw() = 0;

protected:
    AnyField(const AnyField&) = default;
    AnyField(AnyField&&) noexcept = default;
    AnyField& operator=(const AnyField&) = default;
    AnyField& operator=(AnyField&&) noexcept = default;

private:
    const char* name_ = "";
    Law law_ = Law::unseen;
    Kept kept_ = Kept::sorted;
    With with_ = With::water;
    Element element_ = Element::packed;
};

/// The particles' quantities as a list: what is done with all of them goes through here. A quantity is one line, a
/// FieldOf as a member of a struct that derives from this.
class FieldTable {
public:
    bool has(With what) const { return (have_ & static_cast<unsigned>(what)) == static_cast<unsigned>(what); }
    /// From now on the level has that as well.
    void allocate(With what) {
        have_ |= static_cast<unsigned>(what);
        const std::size_t n = particles();
        each([&](AnyField& f) {
            if (f.moves() && has(f.with())) f.set_length(n);
        });
    }
    /// What `other` has.
    void allocate_as(const FieldTable& other) { allocate(static_cast<With>(other.have_)); }

    /// What is saved of other particles, and nothing else of these.
    void copy_saved_of(const FieldTable& other) {
        have_ = other.have_;
        for (const std::ptrdiff_t at : places_) {
            AnyField& field = at_place(at);
            field.let_go();
            const AnyField& from = other.at_place(at);
            if (!from.saved() || !has(from.with())) continue;
            field.set_length(from.length());
            if (from.length() > 0) std::memcpy(field.raw(), from.raw(), from.length() * from.element_bytes());
        }
    }

    /// Calls `f(field)` for each, whether the level has it or not.
    template <class Function>
    void each(const Function& f) {
        for (const std::ptrdiff_t at : places_) f(at_place(at));
    }
    template <class Function>
    void each(const Function& f) const {
        for (const std::ptrdiff_t at : places_) f(at_place(at));
    }

    /// Another particle, with the default of every quantity that moves with it; gives its index.
    std::size_t grow() {
        const std::size_t i = particles();
        resize(i + 1);
        return i;
    }
    void reserve(std::size_t n) {
        each([&](AnyField& f) {
            if (f.moves() && has(f.with())) f.set_capacity(n);
        });
    }
    /// New order: particle k becomes what particle order[k] was; particles not named are dropped.
    void reorder(const std::vector<std::int32_t>& order) {
        each([&](AnyField& f) {
            if (f.moves() && has(f.with())) f.take(order);
        });
    }
    /// Bytes of all that moves with a particle, and those bytes taken out of here and put in.
    std::size_t moved_bytes() const {
        std::size_t sum = 0;
        each([&](const AnyField& f) {
            if (f.moves() && has(f.with())) sum += f.element_bytes();
        });
        return sum;
    }
    void pack(std::size_t i, std::byte* to) const {
        each([&](const AnyField& f) {
            if (!f.moves() || !has(f.with())) return;
            const std::size_t n = f.element_bytes();
            std::memcpy(to, static_cast<const std::byte*>(f.raw()) + i * n, n);
            to += n;
        });
    }
    void unpack(std::size_t i, const std::byte* from) {
        each([&](AnyField& f) {
            if (!f.moves() || !has(f.with())) return;
            const std::size_t n = f.element_bytes();
            std::memcpy(static_cast<std::byte*>(f.raw()) + i * n, from, n);
            from += n;
        });
    }
    /// So many particles, those beyond the present ones with defaults.
    void resize(std::size_t n) {
        each([&](AnyField& f) {
            if (f.moves() && has(f.with())) f.set_length(n);
        });
    }
    /// Lengths of what does not move for the particles that are there and so many images of them.
    void make_room(std::size_t images) {
        const std::size_t n = particles();
        each([&](AnyField& f) {
            if (!f.moves() && has(f.with())) f.set_length(f.in_images() ? n + images : n);
        });
    }
    std::size_t bytes() const {
        std::size_t sum = 0;
        each([&](const AnyField& f) { sum += f.bytes(); });
        return sum;
    }

private:
    template <class, Law>
    friend class FieldOf;

    void add(AnyField& field) {
        places_.push_back(reinterpret_cast<std::byte*>(&field) - reinterpret_cast<std::byte*>(this));
    }
    AnyField& at_place(std::ptrdiff_t at) {
        return *reinterpret_cast<AnyField*>(reinterpret_cast<std::byte*>(this) + at);
    }
    const AnyField& at_place(std::ptrdiff_t at) const {
        return *reinterpret_cast<const AnyField*>(reinterpret_cast<const std::byte*>(this) + at);
    }
    /// The first field is one that every particle has.
    std::size_t particles() const { return at_place(places_.front()).length(); }

    std::vector<std::ptrdiff_t> places_;  ///< of the fields, from this table: the same in a copy of it
    unsigned have_ = 0;
};

/// One quantity of all particles, and of their images where it has a law.
template <class T, Law law = Law::unseen>
class FieldOf : public std::vector<T>, public AnyField {
public:
    using std::vector<T>::operator=;

    FieldOf(FieldTable& table, const char* name, Kept kept, With with = With::water)
        : AnyField(name, law, kept, with, element_of()) {
        table.add(*this);
    }

    std::size_t length() const override { return this->size(); }
    void set_length(std::size_t n) override { this->resize(n); }
    void set_capacity(std::size_t n) override { this->reserve(n); }
    void let_go() override { static_cast<std::vector<T>&>(*this) = {}; }
    void take(const std::vector<std::int32_t>& order) override {
        const std::vector<T> old = std::move(static_cast<std::vector<T>&>(*this));
        static_cast<std::vector<T>&>(*this) = {};
        this->resize(order.size());
        for_particles(order.size(), [to = this->data(), from = old.data(), &order](std::size_t k) {
            to[k] = from[static_cast<std::size_t>(order[k])];
        });
    }
    std::size_t bytes() const override { return this->capacity() * sizeof(T); }
    std::size_t element_bytes() const override { return sizeof(T); }
    const void* raw() const override { return this->data(); }
    void* raw() override { return this->data(); }

private:
    static constexpr Element element_of() {
        if (std::is_same_v<T, double>) return Element::float64;
        if (std::is_same_v<T, float>) return Element::float32;
        if (std::is_same_v<T, std::int64_t>) return Element::int64;
        return sizeof(T) == 1 && (std::is_enum_v<T> || std::is_integral_v<T>) ? Element::uint8 : Element::packed;
    }
};

/// A bit for each particle and image: bit i % 32 of word i / 32, and one word more at the end.
class Marks : public FieldOf<std::uint32_t, Law::scalar> {
public:
    using FieldOf::FieldOf;
    void set_length(std::size_t n) override { assign(n / 32 + 2, 0); }
};

}  // namespace tw
