float _Strength;
